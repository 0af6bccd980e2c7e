"""submissions.py - what is a submission, and the answers in it.

Every entry of the class's folder is one, or a part of one, whatever is wrong with it: whoever handed in anything has
a result. Only what nobody hands in is not: hidden files, what systems and platforms leave, the instructor's own
tables and notes. Nothing here follows a symbolic link, writes anything, or trusts a size; anything odd is reported in
words. Whoever calls collect does so in a process with limits on memory and time.

What learning platforms export is read by platforms.py. Everything else is a submission under its own name: folders,
archives, and loose files, which hold no answer but whose owner has handed in something.
"""
from __future__ import annotations

import hashlib
import os
import re
from dataclasses import dataclass
from typing import Callable, Iterable, Optional

from grade.confine.machine import GraderFailed, believed, must_be_its_own
from grade.visible import why
from . import answers, archives, folders, names, streams
from .answers import Collected
from .platforms import Part, are_all_named, grouped, titled
from .streams import Enough

# ---- submissions --------------------------------------------------------------------------------


# Nobody hands these in.
HIDDEN = re.compile(r"\..*|__MACOSX", re.DOTALL)
MOST_AROUND = 3     # folders around a class's
NO_ANSWER = "a loose file, and neither a folder nor an archive"


@dataclass(frozen=True)
class Submission:
    name: str       # as people read it; no two are the same
    folder: str     # the folder of its reports; no two are the same, on any file system
    parts: tuple
    claims: tuple = ()              # whose it says it is (platforms.py)
    person: Optional[object] = None  # whose it is, by the list of the class (people/)
    unlisted: str = ""              # why it is nobody's on that list
    is_elsewhere: bool = False      # marked before, and not in this folder of submissions

    @property
    def key(self) -> str:
        """What decisions about it go by."""
        return self.person.key if self.person else self.folder

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
            return ("archive", "") if archives.suffix_of(names.decoded(entry.name)) else ("file", NO_ANSWER)
        return "unreadable", "neither a file nor a folder, not opened"
    except OSError as error:
        return "unreadable", f"cannot be read: {why(error)}"


def is_nobody_s(raw: bytes, kind: str, stems: list) -> bool:
    """Clutter; and an answer that lies loose, of which nobody knows whose it is."""
    name = names.decoded(raw)
    if HIDDEN.fullmatch(name):
        return True
    return kind != "folder" and bool(names.is_clutter(name) or name in [f"{stem}.c" for stem in stems])


def entries_of(directory: bytes, stems: list) -> tuple:
    """(Part, its name's bytes) of each that may be a submission; and the names of what is none."""
    entries, others = [], []
    with os.scandir(directory) as listing:
        for entry in sorted(listing, key=lambda entry: entry.name):
            kind, words = kind_of(entry)
            if is_nobody_s(entry.name, kind, stems):
                others.append(entry.name)
            else:
                entries.append((Part(entry.path, kind, "", words), entry.name))
    return entries, others


def inside_of(directory: bytes, stems: list, are_people: Callable[[list], bool]) -> tuple:
    """The entries of the class's folder, or of the one folder in it, if that is not a student's. are_people: whether
    such entries are, by the list of the class."""
    entries, others = entries_of(directory, stems)
    below, clutter = entries, others
    for _ in range(MOST_AROUND):
        if len(below) != 1 or below[0][0].kind != "folder" or are_all_named(below):
            break
        around = below[0][0].path
        below, more = entries_of(around, stems)
        clutter = clutter + more
        if are_all_named(below) or are_people([raw for _, raw in below]):
            return around, below, clutter
    return directory, entries, others


def find(directory, stems: Iterable[str] = (), are_people: Callable[[list], bool] = lambda raws: False) -> tuple:
    """The submissions in the order of their names' bytes; and the names of what is none."""
    directory, entries, others = inside_of(os.fsencode(directory), list(stems), are_people)
    owners = list(titled(grouped(entries), directory))
    shown = names.shown([owner.title.encode("utf-8", "surrogateescape") for owner in owners])
    stored = names.folders([(owner.raw, len(archives.suffix_of(names.decoded(owner.raw))) if owner.parts[0].kind == "archive" else 0)
                            for owner in owners])
    return ([Submission(name, folder, owner.parts, owner.claims) for owner, name, folder in zip(owners, shown, stored)],
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
        search.upload, before = part.upload, search.when
        search.uploads[part.upload] = part.said
        try:
            look_at(search, part, opener)
            if part.when is not None:
                search.when = max(before or part.when, part.when)
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
