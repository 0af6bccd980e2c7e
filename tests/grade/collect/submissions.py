"""submissions.py - what is a submission, and the answers in it.

Every entry of the class's folder is one, or a part of one (exports.py), whatever is wrong with it:
whoever handed in anything has a result. Only what nobody hands in is not: hidden files, what systems
and platforms leave, the instructor's own tables and notes. Nothing here follows a symbolic link,
writes anything, or trusts a size; anything odd is reported in words. Whoever calls collect does so in a
process with limits on memory and time.
"""
from __future__ import annotations

import hashlib
import os
import re
from dataclasses import dataclass
from typing import Callable, Iterable, Optional

from grade.confine.machine import GraderFailed
from grade.visible import why
from . import answers, archives, exports, folders, names
from .answers import Collected
from .exports import Part
from .limits import Enough

SUFFIXES = tuple(suffix.encode() for suffix in archives.SUFFIXES)
# Nobody hands these in.
HIDDEN = re.compile(r"\..*|__MACOSX", re.DOTALL)
NOTES = re.compile(r"thumbs\.db|desktop\.ini|submission_metadata\.yml|read ?me(\..*)?|.*\.csv", re.IGNORECASE | re.DOTALL)
NO_ANSWER = "a loose file, and neither a folder nor an archive"


@dataclass(frozen=True)
class Submission:
    path: bytes     # of its first part
    name: str       # as people read it; no two are the same
    folder: str     # the folder of its reports; no two are the same, on any file system
    kind: str       # of its first part: folder, archive, file, link, unreadable
    words: str = ""  # why there is nothing to look at
    parts: tuple = ()


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
    return kind != "folder" and bool(NOTES.fullmatch(name) or name in [f"{stem}.c" for stem in stems])


def suffix_of(owner: exports.Owner) -> int:
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
    owners = list(exports.titled(exports.grouped(entries), directory))
    shown = names.shown([owner.title.encode("utf-8", "surrogateescape") for owner in owners])
    stored = names.folders([(owner.raw, suffix_of(owner)) for owner in owners])
    return ([Submission(owner.parts[0].path, name, folder, owner.parts[0].kind, owner.parts[0].words, owner.parts)
             for owner, name, folder in zip(owners, shown, stored)],
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
        answers.note(search, part.words)


def collect(submission: Submission, stems: Iterable[str],
            opener: Optional[Callable[[list], list]] = None) -> Collected:
    """The answers of a submission, or words. GraderFailed, if some are perhaps in an archive that only
    this machine cannot read; no other exception. opener: how a program that unpacks is started, a
    command to a command (a sandbox's)."""
    stems = list(stems)
    search = answers.search_for(stems)
    parts = submission.parts or (Part(submission.path, submission.kind, "", submission.words),)
    for part in parts:
        try:
            look_at(search, part, opener)
        except MemoryError:
            search = answers.search_for(stems)
            answers.note(search, "reading it takes more memory than a submission may have")
        except (Exception, Enough) as error:
            answers.note(search, f"cannot be read: {why(error)}")
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
    sum_of.update(collected.words.encode())
    return sum_of.hexdigest()
