"""names.py - names that people can read, and names that a file system can hold.

A submission's name is chosen by whoever made it: any bytes but / and NUL. What is shown holds no
character that moves, hides or ends a line; and two that differ are shown, and stored, apart.
"""
import hashlib
import re
import unicodedata
from collections import defaultdict

LONGEST = 200  # bytes; file systems allow 255, and temporary names need room
RESERVED = {"grades.csv", "junit.xml", "grades.tap", "index.html"}
# Printable, says Unicode, and yet not to be seen.
BLANK = re.compile("[\u034f\u115f\u1160\u17b4\u17b5\u2800\u3164\uffa0\ufe00-\ufe0f"
                   "\U000e0100-\U000e01ef]")
LETTERS = {"\n": "\\n", "\r": "\\r", "\t": "\\t", "\\": "\\\\"}


def decoded(raw: bytes) -> str:
    """As UTF-8; a byte that is none becomes a lone surrogate, whatever the locale."""
    return raw.decode("utf-8", "surrogateescape")


def escaped(character: str) -> str:
    code = ord(character)
    return LETTERS.get(character) or (
        f"\\x{code:02x}" if code < 0x100 else
        f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}")


def visible(text: str, ascii_only: bool = False) -> str:
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


def short(text: str, most: int = 160) -> str:
    """What is too long loses its middle: the ends tell more."""
    if len(text) <= most:
        return text
    return text[:most // 3] + " ... " + text[len(text) - most + most // 3 + 5:]


def shown(raws: list) -> list:
    """The names of a class as people read them. Where two differ only in how a letter is coded,
    the code is shown."""
    texts = [decoded(raw) for raw in raws]
    alike = defaultdict(int)
    for text in texts:
        alike[unicodedata.normalize("NFKC", text)] += 1
    return [visible(text, ascii_only=alike[unicodedata.normalize("NFKC", text)] > 1)
            for text in texts]


def key(name: str) -> str:
    """Equal where some file system would take two names for one: macOS ignores case and coding."""
    return unicodedata.normalize("NFKC", unicodedata.normalize("NFKC", name).casefold())


def allowed(name: str) -> bool:
    return (name != "" and not name.startswith(".") and key(name) not in RESERVED
            and len(name.encode()) <= LONGEST)


def wishes(raw: bytes, suffix: int) -> list:
    """Folder names for one entry, from the nicest to the surest, each with its rank."""
    own = re.sub("[\udc80-\udcff]", lambda m: f"%{ord(m[0]) - 0xdc00:02X}", decoded(raw))
    mark = hashlib.sha256(raw).hexdigest()
    cut = own.lstrip(".").encode()[:LONGEST - 13].decode("utf-8", "ignore")
    names = [own[:-suffix] if suffix else "", own, f"{cut}~{mark[:12]}", mark]
    return [(rank, name) for rank, name in enumerate(names) if allowed(name)]


def folders(entries: list) -> list:
    """A folder name for each entry (its bytes, the length of its archive suffix): its own name
    without the suffix, and something longer only where that is taken or not allowed."""
    left = [wishes(raw, suffix) for raw, suffix in entries]
    while True:
        groups = defaultdict(list)
        for wish in left:
            groups[key(wish[0][1])].append(wish)
        crowded = [group for group in groups.values() if len(group) > 1]
        if not crowded:
            return [wish[0][1] for wish in left]
        for group in crowded:  # whoever asked for the nicest name gives way; equals all do
            lowest = min(wish[0][0] for wish in group)
            for wish in group:
                if wish[0][0] == lowest:
                    del wish[0]
