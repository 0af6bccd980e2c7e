"""visible.py - what others wrote, made safe to print: nothing in it acts, everything shows.

Names of files and compilers' words quote students. Control characters, direction overrides, halves
of surrogates and what is no character at all become escapes that can be read (\\x1b, \\u202e), so
that no format has to be asked what it makes of them. Saying it twice changes nothing.
"""
import unicodedata

LONGEST = 10_000  # characters of one string; the record cuts earlier, this is the net below it


def escape(character: str) -> str:
    code = ord(character)
    if character in "\n\r\t":
        return {"\n": "\\n", "\r": "\\r", "\t": "\\t"}[character]
    if 0xDC80 <= code <= 0xDCFF:  # a byte that was no UTF-8, as os.fsdecode hands it on
        return f"\\x{code - 0xDC00:02x}"
    if code < 0x100:
        return f"\\x{code:02x}"
    return f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def visible(text: str, lines: bool = False) -> str:
    """One line; or lines, where ends of lines are the author's own and stay."""
    if lines:
        text = text.replace("\r\n", "\n").expandtabs(8)
    if len(text) > LONGEST:
        text = text[:LONGEST] + " ... (cut)"
    if text.isprintable():
        return text
    keep = "\n" if lines else ""
    return "".join(c if c.isprintable() or c in keep else escape(c) for c in text)


def clean(record: dict) -> dict:
    """A copy of a submission's record in which every string is visible."""

    def copy(value, lines=False):
        if isinstance(value, str):
            return visible(value, lines)
        if isinstance(value, dict):
            # Only a compiler has several lines to say, and says them of a stem.
            return {visible(k): copy(v, k == "words" and "stem" in value) for k, v in value.items()}
        if isinstance(value, (list, tuple)):
            return [copy(one) for one in value]
        return value

    return copy(record)


def width(text: str) -> int:
    """Columns on a terminal: East Asian characters take two, what stands on another takes none."""
    if text.isascii():
        return len(text)
    return sum(
        0 if unicodedata.combining(c) else 2 if unicodedata.east_asian_width(c) in "WF" else 1
        for c in text
    )


def fitted(text: str, columns: int) -> str:
    """Cut or padded to exactly so many columns."""
    text = text[: 4 * columns]
    if width(text) > columns:
        while width(text) > columns - 2:
            text = text[:-1]
        text += ".."
    return text + " " * (columns - width(text))


def number(marks: float) -> str:
    """Marks as people write them: 74, 18.5."""
    text = f"{marks:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
