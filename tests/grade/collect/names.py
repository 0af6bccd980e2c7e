"""names.py - names that people can read, and names that a file system can hold.

The student chooses the name of a submission: any bytes but / and NUL. The shown name holds no
character that moves, hides or ends a line; and two that differ are shown, and stored, apart.
"""
import hashlib
import re
import unicodedata
from collections import defaultdict

from grade.visible import spelled

LONGEST = 200  # bytes; file systems allow 255, and temporary names need room
# Nobody hands these in: what systems and platforms leave, and the instructor's own tables and notes.
CLUTTER = re.compile(r"\..*|__MACOSX|thumbs\.db|desktop\.ini|submission_metadata\.yml|index\.html|read ?me(\..*)?|"
                     r".*\.(csv|xlsx?|ods|numbers)", re.IGNORECASE | re.DOTALL)
RESERVED = {"grades.csv", "history.csv", "ledger.csv", "figures", "return", "similar.html", "junit.xml", "index.html"}


def decoded(raw: bytes) -> str:
    """As UTF-8; a byte that is none becomes a lone surrogate, whatever the locale."""
    return raw.decode("utf-8", "surrogateescape")


def is_clutter(name: str) -> bool:
    return bool(CLUTTER.fullmatch(name))


def shown(raws: list) -> list:
    """The names of a class as people read them. Where two differ only in how a letter is coded,
    the code is shown."""
    texts = [decoded(raw) for raw in raws]
    alike = defaultdict(int)
    for text in texts:
        alike[unicodedata.normalize("NFKC", text)] += 1
    return [spelled(text, ascii_only=alike[unicodedata.normalize("NFKC", text)] > 1)
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
    without the suffix, and something longer only if that is taken or not allowed."""
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
