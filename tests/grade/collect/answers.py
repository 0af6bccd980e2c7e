"""answers.py - the answers that are found in one submission, wherever it keeps them.

Folders and archives are searched by other files; each file they see is handed to here. Of each
NN-stem.c there is one, or none with the reason. If two of them differ, the grader never guesses.
Two rules say which files are meant before they are compared:

- A copy of the toolkit or of the handout has files of an answer's name in many places. Its exercises/
  are the answers; its solutions/, tests/, build/ and the like are not looked at.
- Of a platform's uploads, the last one that has the file counts. Within an upload, a file outside an
  archive counts before one inside it.

A submission of which something cannot be read says so in its status, because nobody knows what it would
have earned.
"""
from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Optional

from grade.visible import brief, several
from .names import is_clutter

LARGEST = 256 * 1024     # of one answer; the references have 5 KB
PLACES = 5               # that are named; the rest are counted
NOT_FOLLOWED = "a symbolic link, not followed"
OF_THE_TOOLKIT = {".git", ".github", ".make", "build", "chapters", "common", "solutions", "tests"}
DEEPEST = 50             # folders on the way to a copy of the toolkit
EMPTY, UNREADABLE, PARTLY = "empty", "cannot be read", "partly read"


@dataclass
class Answer:
    state: str = "missing"  # found, missing, twice, unreadable
    file: str = ""          # where it was found, as people read it
    text: bytes = b""       # what is compiled
    words: str = ""         # why it was not found, or another remark
    upload: int = 0         # the platform's number; larger: later


@dataclass
class Collected:
    answers: dict           # stem -> Answer, in the order of the chapters
    words: str = ""         # of the submission as a whole: why it is empty, what was not looked at
    empty: bool = True      # not one NN-stem.c
    status: str = ""        # EMPTY, UNREADABLE or PARTLY; else it was read
    when: Optional[int] = None  # seconds since 1970: when the newest of it was written


@dataclass(frozen=True)
class File:
    """One file of an answer's name."""
    parts: tuple            # folders and name
    level: int              # archives that were opened on the way to it
    text: Optional[bytes]   # None where it cannot be read
    fault: str = ""         # and why
    upload: int = 0


@dataclass
class Seen:
    """The files of one name, so far."""
    files: list = field(default_factory=list)
    texts: dict = field(default_factory=dict)   # each text once: there may be thousands of one
    aside: list = field(default_factory=list)   # of that name, but no file
    near: list = field(default_factory=list)    # almost of that name


@dataclass
class Search:
    seen: dict                                  # stem -> Seen
    notes: list = field(default_factory=list)
    others: list = field(default_factory=list)   # files that are not answers
    upload: int = 0                             # the one that is being searched
    uploads: dict = field(default_factory=dict)  # what each is called
    unread: int = -1                            # the last upload of which something could not be read
    exercises: set = field(default_factory=set)  # folders of that name that hold an exercise
    when: Optional[int] = None
    lacks: str = ""                             # why this machine could not read an archive
    refused: bool = False                       # a program could not read an archive


def search_for(stems) -> Search:
    return Search({stem: Seen() for stem in stems})


def stem_of(search: Search, base: str) -> Optional[str]:
    return base[:-2] if base.endswith(".c") and base[:-2] in search.seen else None


def note(search: Search, words: str) -> None:
    """Something odd about the submission; of a thousand odd things, the first few."""
    if words not in search.notes and len(search.notes) < PLACES:
        search.notes.append(words)


def not_read(search: Search, words: str) -> None:
    """Something that may hold answers, and cannot be read."""
    search.unread = max(search.unread, search.upload)
    note(search, words)


def ended_early(search: Search, words: str) -> None:
    """Why not everything was read. This comes before all other remarks."""
    search.unread = max(search.unread, search.upload)
    search.notes.insert(0, words)


def written(search: Search, when: int) -> None:
    search.when = max(search.when or when, when)


def place_of(parts) -> str:
    return brief("/".join(parts))


def as_text(raw: bytes) -> Optional[bytes]:
    """UTF-8 without a mark, lines ending in a newline; None if it is not text."""
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


# ---- copies of the toolkit ----------------------------------------------------------------------

def passed(search: Search, parts) -> None:
    """Each file goes by here: where an exercise or its contract is, a copy of the toolkit may be."""
    if len(parts) > 1 and parts[-2] == "exercises" and parts[-1][-2:] in (".c", ".h") \
            and parts[-1][:-2] in search.seen:
        search.exercises.add(tuple(parts[:-1]))


def is_toolkit_s(search: Search, parts) -> bool:
    """Whether it is the toolkit's own: in a folder of the toolkit's beside exercises/."""
    return any(part in OF_THE_TOOLKIT and (*parts[:i], "exercises") in search.exercises
               for i, part in enumerate(parts[:DEEPEST]))


# ---- what is found ------------------------------------------------------------------------------

def bystander(search: Search, parts) -> None:
    """A file that is not an answer; it may be the reason why there is none."""
    base = parts[-1]
    if len(search.others) <= PLACES and not is_clutter(base):
        search.others.append(tuple(parts))
    number = re.match(r"0*(\d+).*\.c(pp|\.txt)?$", base, re.IGNORECASE)
    for stem, seen in search.seen.items() if number else ():
        if number[1] == re.match(r"0*(\d*)", stem)[1] and len(seen.near) < PLACES:
            seen.near.append(tuple(parts))


def unreadable(search: Search, parts, why: str, level: int = 0) -> None:
    passed(search, parts)
    search.seen[stem_of(search, parts[-1])].files.append(File(tuple(parts), level, None, why, search.upload))


def found(search: Search, parts, raw: bytes, level: int = 0) -> None:
    text = as_text(raw)
    if len(raw) > LARGEST:
        return unreadable(search, parts, f"is larger than {LARGEST // 1024} KB", level)
    if text is None:
        return unreadable(search, parts, "is not text", level)
    passed(search, parts)
    seen = search.seen[stem_of(search, parts[-1])]
    seen.files.append(File(tuple(parts), level, seen.texts.setdefault(text, text), upload=search.upload))
    return None


def no_file(search: Search, parts, what: str) -> None:
    """It has the name of an answer, and is a link, a fifo, a device."""
    seen = search.seen[stem_of(search, parts[-1])]
    if len(seen.aside) < PLACES:
        seen.aside.append(f"{place_of(parts)} is {what}")


# ---- which of them is meant -----------------------------------------------------------------------

def listed(places: list) -> str:
    return several([place_of(parts) for parts in places], PLACES)


def places(files: list) -> list:
    return [file.parts for file in files]


def answer_from(search: Search, stem: str, seen: Seen) -> Answer:
    words = list(seen.aside)
    files = [file for file in seen.files if not is_toolkit_s(search, file.parts)]
    if not files:
        near = [place_of(parts) for parts in seen.near if not is_toolkit_s(search, parts)]
        if near:
            words.append(f"there is {', '.join(near)}; the name must be {stem}.c")
        return Answer("missing", words="; ".join(words))
    upload = max(file.upload for file in files)
    earlier = len({file.upload for file in files}) - 1
    if earlier:
        words.append(f"handed in {earlier + 1} times; the last one counts: {search.uploads.get(upload, upload)}")
    files = [file for file in files if file.upload == upload]
    outermost = min(file.level for file in files)
    meant = [file for file in files if file.level == outermost]
    deeper = [file for file in files if file.level > outermost and file.text != meant[0].text]
    if deeper:
        words.append(f"in an archive beside it there is another, which does not count: {listed(places(deeper))}")
    first, texts = meant[0], {file.text for file in meant}
    if len(meant) == 1 and first.text is None:
        words.insert(0, f"{place_of(first.parts)} {first.fault}")
        return Answer("unreadable", place_of(first.parts), words="; ".join(words), upload=upload)
    if len(texts) > 1 or None in texts:
        words.insert(0, f"{len(meant)} files are called {stem}.c and are not the same: {listed(places(meant))}")
        return Answer("twice", words="; ".join(words), upload=upload)
    if len(meant) > 1:
        words.insert(0, f"{len(meant)} files with the same text count as one: {listed(places(meant))}")
    return Answer("found", place_of(first.parts), first.text, "; ".join(words), upload)


def status_of(search: Search, answers: list, odd: bool) -> str:
    """odd: there is something in it, and it is not an answer."""
    read = [answer for answer in answers if answer.state in ("found", "twice")]
    if not read:
        return UNREADABLE if odd else EMPTY
    lacks = len(read) < len(answers) or any(answer.upload < search.unread for answer in read)
    if any(answer.state == "unreadable" for answer in answers) or (lacks and search.unread >= 0):
        return PARTLY
    return ""


def all_of(search: Search) -> Collected:
    answers = {stem: answer_from(search, stem, seen) for stem, seen in search.seen.items()}
    empty = all(answer.state == "missing" for answer in answers.values())
    faults = [answer.words for answer in answers.values() if answer.words and answer.state in ("missing", "unreadable")]
    others = [parts for parts in search.others if not is_toolkit_s(search, parts)]
    status = status_of(search, list(answers.values()), bool(search.notes or faults or others))
    words = list(search.notes)
    if status and not words:
        words = faults[:1] + [f"and {len(faults) - 1} more like this"] * (len(faults) > 1)
    if status and not words:
        stems = list(search.seen)
        words = [f"holds no {stems[0]}.c ... {stems[-1]}.c" if stems else "nothing is asked"]
        words[0] += f", only {listed(others)}" if others else ""
    return Collected(answers, "; ".join(words), empty, status, search.when)
