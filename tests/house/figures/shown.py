"""shown.py - numbers as figures, slides and lessons must show them, found in another way than common/shown.c."""
import math
from decimal import Decimal

RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
# One of them, in a text.
NUMBER = r"(?<![\w.,])−?(?:10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+|(?:\d{1,3}(?:,\d{3})+|\d+)(?:\.\d+)?(?: · 10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?)"


def shown(x, digits=4):
    """All digits, if it has at most 6; else at least so many, and those before the point. So many beside a power of 10."""
    short = f"{x:.{max(digits, 6) - 1}e}"
    if x and not 1e-4 <= abs(x) < 1e7:
        short = f"{x:.{digits - 1}e}"
    elif abs(float(short) - x) > 1e-9 * abs(x):
        short = f"{x:.{max(digits, len(str(int(abs(x)))) if abs(x) >= 1 else 0) - 1}e}"
    value = Decimal(short).normalize()
    minus, value, power = "−" if value < 0 else "", abs(value), value.adjusted()
    if value and not -4 <= power <= 6:
        factor = f"{value.scaleb(-power).normalize():f}"
        return minus + ("" if factor == "1" else f"{factor} · ") + f"10{str(power).translate(RAISED)}"
    whole, point, part = f"{value:f}".partition(".")
    return minus + (f"{int(whole):,}" if len(whole) > 4 else whole) + point + part


def read(text):
    """The number that a text shows."""
    factor, _, power = text.rpartition("10") if "10⁻" in text or text[-1] in "⁰¹²³⁴⁵⁶⁷⁸⁹" else (text, "", "")
    power = power.translate({raised: chr(plain) for plain, raised in RAISED.items()})
    sign = -1 if text[0] == "−" else 1
    factor = factor.strip("− ·").replace(",", "") or "1"
    return sign * float(factor) * 10.0 ** int(power or 0)


def shown_vector(v, digits=4):
    """What is only left of rounding is 0."""
    rounding = 1e-13 * math.hypot(*v)
    return "(" + ", ".join(shown(0 if abs(x) <= rounding else x, digits) for x in v) + ")"


def place_digits(columns, rows):
    """Of s and t on a screen: half a pixel makes a difference."""
    return next(digits for digits in range(4, 13) if 10**-digits < 0.5 / max(columns, rows))
