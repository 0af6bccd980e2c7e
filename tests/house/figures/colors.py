"""colors.py - the colors of both themes can be read, and told apart, also by who sees fewer of them."""
import math
import subprocess

from check import Checks, color, contrast, linear

INKS = ("ink", "grey", "blue", "orange", "green", "pink")
LEGIBLE = 4.5
APART = 15  # in CIELAB, where about 2 can be told apart side by side

# What linear red, green and blue become for others (Machado, Oliveira and Fernandes 2009, severity 1).
SEEN = {"everybody": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
        "protanopia": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
        "deuteranopia": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
        "tritanopia": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900))}
XYZ = ((0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505))  # of linear sRGB
WHITE = (0.9505, 1, 1.089)


def changed(matrix, vector):
    return [min(1, max(0, sum(a * b for a, b in zip(row, vector)))) for row in matrix]


def lab(rgb):
    """Of linear red, green and blue, CIELAB: its distances are those that are seen."""
    x, y, z = (t ** (1 / 3) if t > 0.008856 else 7.787 * t + 16 / 116
               for t in (a / b for a, b in zip(changed(XYZ, rgb), WHITE)))
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def theme(checks, name):
    """The colors of common/figure/plot.gp, read by gnuplot itself."""
    words = "; ".join(f'print "{each} ".{each}' for each in (*INKS, "background", "surface"))
    done = subprocess.run(["gnuplot", "-e", f"name='none'; format='txt'; theme='{name}'; load 'common/figure/plot.gp'; {words}"],
                          capture_output=True, text=True, check=True, timeout=60)
    colors = {each: color(code) for each, code in map(str.split, done.stderr.splitlines())}
    for i, ink in enumerate(INKS):
        for ground in ("background", "surface"):
            ratio = contrast(colors[ink], colors[ground])
            checks.that(f"{name}: {ink} can be read on {ground}", ratio >= LEGIBLE, f"{ratio:.2f} to 1")
        for other in INKS[:i]:
            for who, matrix in SEEN.items():
                away = math.dist(*(lab(changed(matrix, linear(colors[each]))) for each in (ink, other)))
                checks.that(f"{name}, {who}: {ink} is not {other}", away >= APART, f"{away:.1f} apart, expected {APART}")


def main():
    checks = Checks("colors of figures")
    theme(checks, "light")
    theme(checks, "dark")
    checks.end()


main()
