"""answers.py - the answers that are found in one submission, wherever it keeps them.

Folders and archives are searched by other files; each file they see is handed to here. Of each
NN-stem.c there is one, or none, or it is said why not: two that differ are never guessed between.
"""
from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Optional

from visible import brief

LARGEST = 256 * 1024     # of one answer; the references have 5 KB
PLACES = 5               # that are named; the rest are counted
ARCHIVES = (".zip", ".tar.gz", ".tgz", ".tar", ".rar", ".7z", ".gz", ".xz", ".bz2")
NOT_FOLLOWED = "a symbolic link, not followed"


@dataclass
class Answer:
    state: str = "missing"  # found, missing, twice, unreadable
    file: str = ""          # where it was found, as people read it
    text: bytes = b""       # what is compiled
    words: str = ""         # why it was not found; or what else is to be said


@dataclass
class Collected:
    answers: dict           # stem -> Answer, in the order of the chapters
    words: str = ""         # of the submission as a whole: why it is empty, what was not looked at
    empty: bool = True      # not one NN-stem.c
    when: Optional[int] = None  # seconds since 1970: when the newest of it was written


@dataclass
class Seen:
    """The files of one name, so far. Only the first text is kept: there may be thousands."""
    places: list = field(default_factory=list)
    count: int = 0
    text: Optional[bytes] = None
    faults: list = field(default_factory=list)
    differ: bool = False
    aside: list = field(default_factory=list)   # of that name, but no file
    near: list = field(default_factory=list)    # almost of that name


@dataclass
class Search:
    seen: dict                                  # stem -> Seen
    notes: list = field(default_factory=list)
    inside: str = ""                            # an archive in the submission
    when: Optional[int] = None


def search_for(stems) -> Search:
    return Search({stem: Seen() for stem in stems})


def stem_of(search: Search, base: str) -> Optional[str]:
    return base[:-2] if base.endswith(".c") and base[:-2] in search.seen else None


def note(search: Search, words: str) -> None:
    """Something odd about the submission; of a thousand odd things, the first few."""
    if words not in search.notes and len(search.notes) < PLACES:
        search.notes.append(words)


def ended_early(search: Search, words: str) -> None:
    """Why not all was looked at: whatever else is said, this comes first."""
    search.notes.insert(0, words)


def place_of(parts) -> str:
    return brief("/".join(parts))


def as_text(raw: bytes) -> Optional[bytes]:
    """UTF-8 without a mark, lines ending in a newline; None where it is no text."""
    try:
        if raw.startswith((b"\xff\xfe", b"\xfe\xff")):
            raw = raw.decode("utf-16").encode()
    except UnicodeError:
        return None
    if raw.startswith(b"\xef\xbb\xbf"):
        raw = raw[3:]
    if b"\0" in raw:
        return None
    return raw.replace(b"\r\n", b"\n").replace(b"\r", b"\n")


def bystander(search: Search, parts) -> None:
    """A file that is no answer; it may tell why there is none."""
    base = parts[-1]
    if base.lower().endswith(ARCHIVES) and not base.startswith("._"):
        search.inside = search.inside or place_of(parts)
    number = re.match(r"0*(\d+).*\.c(pp|\.txt)?$", base, re.IGNORECASE)
    for stem, seen in search.seen.items() if number else ():
        if number[1] == re.match(r"0*(\d*)", stem)[1] and len(seen.near) < PLACES:
            seen.near.append(place_of(parts))


def unreadable(search: Search, parts, why: str) -> None:
    seen = search.seen[stem_of(search, parts[-1])]
    seen.count += 1
    if len(seen.places) < PLACES:
        seen.places.append(place_of(parts))
        seen.faults.append(why)
    seen.differ = True


def found(search: Search, parts, raw: bytes) -> None:
    text = as_text(raw)
    if len(raw) > LARGEST:
        return unreadable(search, parts, f"is larger than {LARGEST // 1024} KB")
    if text is None:
        return unreadable(search, parts, "is not text")
    seen = search.seen[stem_of(search, parts[-1])]
    seen.count += 1
    if len(seen.places) < PLACES:
        seen.places.append(place_of(parts))
    seen.differ = seen.differ or (seen.text is not None and seen.text != text)
    if seen.text is None:
        seen.text = text
    return None


def no_file(search: Search, parts, what: str) -> None:
    """It has the name of an answer, and is a link, a fifo, a device."""
    seen = search.seen[stem_of(search, parts[-1])]
    if len(seen.aside) < PLACES:
        seen.aside.append(f"{place_of(parts)} is {what}")


def answer_from(stem: str, seen: Seen) -> Answer:
    places = ", ".join(seen.places)
    if seen.count > len(seen.places):
        places += f" and {seen.count - len(seen.places)} more"
    words = list(seen.aside)
    if seen.count == 0:
        if seen.near:
            words.append(f"there is {', '.join(seen.near)}; the name must be {stem}.c")
        return Answer("missing", words="; ".join(words))
    if seen.count == 1 and seen.faults:
        words.insert(0, f"{places} {seen.faults[0]}")
        return Answer("unreadable", seen.places[0], words="; ".join(words))
    if seen.differ:
        words.insert(0, f"{seen.count} files are called {stem}.c and are not the same: {places}")
        if {f"{room}/{stem}.c" for room in ("exercises", "solutions")} <= {
                "/".join(place.split("/")[-2:]) for place in seen.places}:
            words.append("this is a copy of the toolkit; hand in its exercises/")
        return Answer("twice", words="; ".join(words))
    if seen.count > 1:
        words.insert(0, f"{seen.count} files with the same text count as one: {places}")
    return Answer("found", seen.places[0], seen.text, "; ".join(words))


def all_of(search: Search) -> Collected:
    answers = {stem: answer_from(stem, seen) for stem, seen in search.seen.items()}
    empty = all(seen.count == 0 for seen in search.seen.values())
    words = list(search.notes)
    if empty and search.inside:
        words.append(f"holds an archive inside, which is not opened: {search.inside}")
    if empty and not words:
        stems = list(search.seen)
        words.append(f"holds no {stems[0]}.c ... {stems[-1]}.c" if stems else "nothing is asked")
    return Collected(answers, "; ".join(words), empty, search.when)
