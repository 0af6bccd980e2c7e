"""columns.py - words on a terminal, whatever letters they are made of: how wide, cut, wrapped."""
import unicodedata

COLUMNS, LABEL = 79, 13  # as in tests/judge/show.c
NO_BREAK = "\u00a0"  # the judge's ~: a blank at which no line ends


def width(text: str) -> int:
    """Columns on a terminal: East Asian characters take two, combining characters take none."""
    if text.isascii():
        return len(text)
    return sum(
        0 if unicodedata.combining(c) else 2 if unicodedata.east_asian_width(c) in "WF" else 1
        for c in text
    )


def fitted(text: str, columns: int) -> str:
    """Cut or padded to exactly that number of columns."""
    text = text[: 4 * columns]
    if width(text) > columns:
        while width(text) > columns - 2:
            text = text[:-1]
        text += ".."
    return text + " " * (columns - width(text))


def words_of(text: str):
    """Split at blanks, but a vector stays in one piece where it fits."""
    word, depth = "", 0
    for part in text.split(" "):
        word += (" " if word else "") + part
        depth += part.count("(") - part.count(")")
        if depth <= 0:
            yield word
            word, depth = "", 0
        elif width(word) >= COLUMNS - LABEL:
            yield from word.split(" ")
            word, depth = "", 0
    if word:
        yield word


def wrapped(label: str, words: str, indent: int = LABEL) -> list:
    """A label, then words that wrap under each other."""
    lines, line = [], label.ljust(indent)
    for word in filter(None, words_of(words)):
        blank = " " if len(line) > indent else ""
        if blank and width(line) + 1 + width(word) > COLUMNS:
            lines.append(line)
            line, blank = " " * indent, ""
        line += blank + word
    return [line.replace(NO_BREAK, " ").rstrip() for line in lines + [line]]
