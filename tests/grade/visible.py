"""visible.py - what others wrote, made safe to print: nothing in it acts, everything shows.

Control characters, direction overrides, lone surrogates and bytes that are not characters become
escapes that can be read (\\x1b, \\u202e), so that no format has to be asked what it makes of them.
visible() is for words, and saying it twice changes nothing; spelled() is for names, and no two names
come out alike.
"""
from __future__ import annotations

import re

LONGEST = 10_000  # characters of one string; whoever quotes cuts earlier, this is the net below it
# Printable, says Unicode, and yet not to be seen.
BLANK = re.compile("[\u034f\u115f\u1160\u17b4\u17b5\u2800\u3164\uffa0\ufe00-\ufe0f"
                   "\U000e0100-\U000e01ef]")
LETTERS = {"\n": "\\n", "\r": "\\r", "\t": "\\t", "\\": "\\\\"}


def escaped(character: str) -> str:
    code = ord(character)
    return LETTERS.get(character) or (
        f"\\x{code:02x}" if code < 0x100 else
        f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}")


def visible(text: str, lines: bool = False) -> str:
    """One line; or lines, where ends of lines are the author's own and stay."""
    if lines:
        text = text.replace("\r\n", "\n").expandtabs(8)
    if len(text) > LONGEST:
        text = text[:LONGEST] + " ... (cut)"
    if text.isprintable():
        return text
    # A byte that was no UTF-8, as os.fsdecode hands it on, is shown as that byte.
    text = re.sub("[\udc80-\udcff]", lambda m: f"\\x{ord(m[0]) - 0xdc00:02x}", text)
    keep = "\n" if lines else ""
    return "".join(c if c.isprintable() or c in keep else escaped(c) for c in text)


def spelled(text: str, ascii_only: bool = False) -> str:
    """One line in which everything is to be seen; two texts never give the same line."""
    shown = []
    for i, character in enumerate(text):
        if character == " ":
            # At the ends, or after another, a space is lost on most readers.
            hidden = i in (0, len(text) - 1) or text[i - 1] == " "
        else:
            hidden = (character == "\\" or not character.isprintable()
                      or bool(BLANK.match(character)) or (ascii_only and not character.isascii()))
        shown.append(escaped(character) if hidden else character)
    return "".join(shown)


def brief(text: str, most: int = 160) -> str:
    """A name inside a sentence: spelled; what is too long loses its middle, since the ends tell more."""
    text = spelled(text)
    if len(text) <= most:
        return text
    return text[:most // 3] + " ... " + text[len(text) - most + most // 3 + 5:]


def several(names: list, most: int) -> str:
    """The first of them, and how many more there are."""
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + more


def why(error: Exception) -> str:
    """The words of an error, for one of our sentences."""
    words = getattr(error, "strerror", None) or str(error) or type(error).__name__
    return brief(words.strip())


def number(marks: float | None) -> str:
    """Marks as people write them: 74, 18.5. No marks are not 0."""
    if marks is None:
        return "-"
    text = f"{marks:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def score(part: dict) -> str:
    """Of whatever has marks: 18.5 of 20."""
    return "no score" if part["score"] is None else f"{number(part['score'])} of {number(part['max'])}"
