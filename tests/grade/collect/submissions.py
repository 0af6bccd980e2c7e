"""submissions.py - what is a submission, and the answers in it.

Every entry of the class's folder is one, or a part of one, whatever is wrong with it: whoever handed in anything has
a result. Only what nobody hands in is not: hidden files, what systems and platforms leave, the instructor's own
tables and notes. Nothing here follows a symbolic link, writes anything, or trusts a size; anything odd is reported in
words. Whoever calls collect does so in a process with limits on memory and time.

Learning platforms export what is one person's in these ways:

    Canvas      doejane_123_456_01-corners.c      loose files: who, user, upload, name; _LATE after
                doejane_LATE_123_457_hw-1.zip     who; -1, -2 ... before the suffix if handed in again
    Moodle      Jane Doe_123_assignsubmission_file_/     a folder for each, or with 'folders' off
                Jane Doe_123_assignsubmission_file_NAME  loose files
    Gradescope  submission_123/               a folder for each; submission_metadata.yml has the names

Everything else is a submission under its own name: folders (a clone of GitHub Classroom's is one),
archives, and loose files, which hold no answer but whose owner has handed in something.
"""
from __future__ import annotations

import hashlib
import os
import re
from collections import Counter, defaultdict
from dataclasses import dataclass, replace
from typing import Callable, Iterable, Optional

from grade.confine.machine import GraderFailed, believed, must_be_its_own
from grade.visible import why
from . import answers, archives, folders, names, streams
from .answers import Collected
from .names import decoded
from .streams import Enough, opened_file

# ---- what platforms export ----------------------------------------------------------------------


CANVAS = re.compile(r"(?P<who>.+?)(?:_LATE)?_(?P<user>\d{1,18})_(?P<upload>\d{1,18})_(?P<name>.+)",
                    re.ASCII | re.DOTALL)
MOODLE = re.compile(r"(?P<who>.+?)_(?P<user>\d{1,18})_assignsubmission_[a-z]+(?:_(?P<name>.*))?", re.ASCII | re.DOTALL)
AGAIN = re.compile(r"(?P<name>.+?)-\d{1,4}(?P<suffix>(\.[A-Za-z0-9]+)+)", re.ASCII | re.DOTALL)
GRADESCOPE = "submission_metadata.yml"
LARGEST_METADATA = 64 * 1024 * 1024
NAMED = 5   # of a group


@dataclass(frozen=True)
class Part:
    """An entry of the class's folder, or what a platform made of a file that was handed in."""
    path: bytes
    kind: str           # folder, archive, file, link, unreadable
    name: str = ""      # what it was called when it was handed in
    words: str = ""     # why there is nothing to look at
    upload: int = 0     # larger: later


@dataclass(frozen=True)
class Owner:
    """Whose parts these are, as the class's folder says it."""
    raw: bytes
    parts: tuple
    title: str = ""     # as people read it


def matched(pattern, entry: bytes, kind: str):
    text = decoded(entry)
    found = pattern.fullmatch(text) if kind in ("folder", "archive", "file") else None
    return found if found and (kind == "folder" or found["name"]) else None


def handed_in_as(name: str) -> str:
    """Canvas calls a file 01-corners-1.c that is handed in again."""
    again = AGAIN.fullmatch(name)
    return again["name"] + again["suffix"] if again else name


def of_canvas(found: dict) -> dict:
    """The matches that are Canvas's, and not names that happen to look like that: an upload has one
    number, a user one name, and archives of other names of one user alone are rather ws_2025_1_anna.zip."""
    uploads = Counter(match["upload"] for match, _ in found.values())
    users = Counter(user for user, _ in {(match["user"], match["who"]) for match, _ in found.values()})
    names = {handed_in_as(match["name"]) for match, _ in found.values()}
    if len(names) > 1 and len(users) == 1 and all(kind == "archive" for _, kind in found.values()):
        return {}
    return {raw: match for raw, (match, _) in found.items()
            if uploads[match["upload"]] == 1 and users[match["user"]] == 1}


def grouped(entries: list) -> list:
    """entries: (Part, its name's bytes). The owners, in the order of their first entries."""
    canvas = of_canvas({raw: (match, part.kind) for part, raw in entries if part.kind in ("archive", "file")
                        and (match := matched(CANVAS, raw, part.kind))})
    owners = defaultdict(list)
    for part, raw in entries:
        match = matched(MOODLE, raw, part.kind)
        if match is None and raw in canvas:
            match = canvas[raw]
            part = replace(part, upload=int(match["upload"]), name=handed_in_as(match["name"]))
        elif match is not None:
            part = replace(part, name=match["name"] or "")
        owner = f"{match['who']}_{match['user']}".encode("utf-8", "surrogateescape") if match else raw
        owners[owner].append(part)
    return [Owner(raw, tuple(parts)) for raw, parts in owners.items()]


# ---- Gradescope's names -------------------------------------------------------------------------

def unquoted(text: str) -> str:
    text = text.strip()
    return text[1:-1].replace("''", "'") if len(text) > 1 and text[0] == text[-1] and text[0] in "'\"" else text


def people(directory: bytes) -> dict:
    """Folder -> the names of those who handed it in, from Gradescope's list; {} without one."""
    found = defaultdict(list)
    try:
        with opened_file(os.path.join(directory, os.fsencode(GRADESCOPE))) as file:
            lines = file.read(LARGEST_METADATA).decode("utf-8", "replace").splitlines()
    except OSError:
        return {}
    folder, inside = "", False
    for line in lines:
        if match := re.fullmatch(r"['\"]?(submission_\d+)['\"]?:\s*", line):
            folder, inside = match[1], False
        elif re.fullmatch(r"  ?:?submitters:\s*", line):
            inside = True
        elif re.match(r"  ?:?\w", line):
            inside = False
        elif inside and folder and (match := re.fullmatch(r"\s+(?:- +)?:?name: +(.+)", line)):
            found[folder].append(unquoted(match[1]))
    return found


def titled(owners: list, directory: bytes) -> list:
    """With the names of people, where the platform has a list of them."""
    known, taken = people(directory), {decoded(owner.raw) for owner in owners}
    for owner in owners:
        folder = decoded(owner.raw)
        them = known.get(folder, [])
        more = f" and {len(them) - NAMED} more" if len(them) > NAMED else ""
        title = f"{', '.join(them[:NAMED])}{more} ({folder})" if them else folder
        if title in taken:
            title = folder
        taken.add(title)
        yield replace(owner, title=title)


# ---- submissions --------------------------------------------------------------------------------


SUFFIXES = tuple(suffix.encode() for suffix in archives.SUFFIXES)
# Nobody hands these in.
HIDDEN = re.compile(r"\..*|__MACOSX", re.DOTALL)
NO_ANSWER = "a loose file, and neither a folder nor an archive"


@dataclass(frozen=True)
class Submission:
    name: str       # as people read it; no two are the same
    folder: str     # the folder of its reports; no two are the same, on any file system
    parts: tuple

    @property
    def kind(self) -> str:
        return self.parts[0].kind


def kind_of(entry) -> tuple:
    """The kind of a top-level entry, and words if it is neither a folder nor an archive."""
    try:
        if entry.is_symlink():
            return "link", answers.NOT_FOLLOWED
        if entry.is_dir(follow_symlinks=False):
            return "folder", ""
        if entry.is_file(follow_symlinks=False):
            return ("archive", "") if entry.name.lower().endswith(SUFFIXES) else ("file", NO_ANSWER)
        return "unreadable", "neither a file nor a folder, not opened"
    except OSError as error:
        return "unreadable", f"cannot be read: {why(error)}"


def is_nobody_s(raw: bytes, kind: str, stems: list) -> bool:
    """Clutter; and an answer that lies loose, of which nobody knows whose it is."""
    name = names.decoded(raw)
    if HIDDEN.fullmatch(name):
        return True
    return kind != "folder" and bool(names.is_clutter(name) or name in [f"{stem}.c" for stem in stems])


def suffix_of(owner: Owner) -> int:
    return next((len(suffix) for suffix in SUFFIXES if owner.raw.lower().endswith(suffix)), 0) \
        if owner.parts[0].kind == "archive" else 0


def find(directory, stems: Iterable[str] = ()) -> tuple:
    """The submissions in the order of their names' bytes; and the names of what is none."""
    entries, others, stems = [], [], list(stems)
    directory = os.fsencode(directory)
    with os.scandir(directory) as listing:
        for entry in sorted(listing, key=lambda entry: entry.name):
            kind, words = kind_of(entry)
            if is_nobody_s(entry.name, kind, stems):
                others.append(entry.name)
            else:
                entries.append((Part(entry.path, kind, "", words), entry.name))
    owners = list(titled(grouped(entries), directory))
    shown = names.shown([owner.title.encode("utf-8", "surrogateescape") for owner in owners])
    stored = names.folders([(owner.raw, suffix_of(owner)) for owner in owners])
    return ([Submission(name, folder, owner.parts) for owner, name, folder in zip(owners, shown, stored)],
            names.shown(others))


def look_at_file(search, part: Part) -> None:
    """A loose file that a platform has put a person's name on."""
    parts = [part.name]
    if not answers.stem_of(search, part.name):
        answers.bystander(search, parts)
        return
    try:
        raw, when = folders.read(part.path)
    except OSError as error:
        answers.unreadable(search, parts, f"cannot be read: {why(error)}")
        return
    answers.written(search, when)
    answers.found(search, parts, raw)


def look_at(search, part: Part, opener) -> None:
    if part.kind == "folder":
        folders.look(search, part.path, opener)
    elif part.kind == "archive":
        archives.look(search, part.path, opener)
    elif part.name:
        look_at_file(search, part)
    else:
        answers.not_read(search, part.words)


def searched(submission: Submission, stems: list, opener) -> answers.Search:
    search = answers.search_for(stems)
    for part in submission.parts:
        search.upload = part.upload
        try:
            look_at(search, part, opener)
        except MemoryError:
            search = answers.search_for(stems)
            answers.not_read(search, "reading it takes more memory than a submission may have")
        except (Exception, Enough) as error:
            if isinstance(error, OSError):
                must_be_its_own(error)
            answers.not_read(search, f"cannot be read: {why(error)}")
    return search


def collect(submission: Submission, stems: Iterable[str],
            opener: Optional[Callable[[list], list]] = None) -> Collected:
    """The answers of a submission, or words. GraderFailed, if this machine is at fault that some are perhaps not
    found; no other exception. opener: how a program that unpacks is started, a
    command to a command (a sandbox's)."""
    stems = list(stems)

    def again(_) -> answers.Search:
        streams.must_read_something_right(opener)
        search = searched(submission, stems, opener)
        streams.must_read_something_right(opener)
        return search

    search = believed({"": searched(submission, stems, opener)}, lambda search: search.refused, again)[""]
    collected = answers.all_of(search)
    if search.lacks and any(answer.state == "missing" for answer in collected.answers.values()):
        raise GraderFailed(search.lacks)
    return collected


def digest(collected: Collected) -> str:
    """Changes when anything changes that a verdict or its words depend on, but for the time."""
    sum_of = hashlib.sha256()
    for stem, answer in sorted(collected.answers.items()):
        for part in (stem, answer.state, answer.file, answer.words, answer.text):
            raw = part if isinstance(part, bytes) else part.encode()
            sum_of.update(b"%d:" % len(raw) + raw)
    sum_of.update(f"{collected.status}: {collected.words}".encode())
    return sum_of.hexdigest()
