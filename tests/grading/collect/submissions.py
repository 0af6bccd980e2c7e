"""submissions.py - what is a submission, and the answers in it.

Every folder and every archive in the class's folder is one, whatever is wrong with it. Nothing
here follows a symbolic link, writes anything, or trusts a size; what is odd is said in words.
Whoever calls collect does so in a process with limits on memory and time.
"""
from __future__ import annotations

import hashlib
import os
from dataclasses import dataclass
from typing import Iterable

from visible import why
from . import answers, archives, folders, names
from .answers import Collected

SUFFIXES = (b".tar.gz", b".tgz", b".tar", b".zip")


@dataclass(frozen=True)
class Submission:
    path: bytes
    name: str       # as people read it; no two are the same
    folder: str     # the folder of its reports; no two are the same, on any file system
    kind: str       # folder, archive, link, unreadable
    words: str = ""  # why there is nothing to look at


def kind_of(entry) -> tuple:
    """What a top-level entry is, and words where it is neither folder nor archive."""
    try:
        if entry.is_symlink():
            return "link", answers.NOT_FOLLOWED
        if entry.is_dir(follow_symlinks=False):
            return "folder", ""
        if entry.is_file(follow_symlinks=False):
            return ("archive" if entry.name.lower().endswith(SUFFIXES) else "other"), ""
        return "other", ""
    except OSError as error:
        return "unreadable", f"cannot be read: {why(error)}"


def find(directory) -> tuple:
    """The submissions in the order of their names' bytes; and the names of what is none."""
    found, others = [], []
    with os.scandir(os.fsencode(directory)) as listing:
        for entry in sorted(listing, key=lambda entry: entry.name):
            kind, words = kind_of(entry)
            hidden = entry.name.startswith(b".") or entry.name == b"__MACOSX"
            (others if hidden or kind == "other" else found).append((entry, kind, words))
    raws = [entry.name for entry, _, _ in found]
    suffixes = [next(len(suffix) for suffix in SUFFIXES if entry.name.lower().endswith(suffix))
                if kind == "archive" else 0 for entry, kind, _ in found]
    shown, stored = names.shown(raws), names.folders(list(zip(raws, suffixes)))
    return ([Submission(entry.path, name, folder, kind, words)
             for (entry, kind, words), name, folder in zip(found, shown, stored)],
            names.shown([entry.name for entry, _, _ in others]))


def collect(submission: Submission, stems: Iterable[str]) -> Collected:
    """The answers of a submission, or words; never an exception."""
    stems = list(stems)
    search = answers.search_for(stems)
    try:
        if submission.kind == "folder":
            folders.look(search, submission.path)
        elif submission.kind == "archive":
            archives.look(search, submission.path)
        else:
            answers.note(search, submission.words)
    except MemoryError:
        search = answers.search_for(stems)
        answers.note(search, "reading it takes more memory than a submission may have")
    except Exception as error:
        answers.note(search, f"cannot be read: {why(error)}")
    return answers.all_of(search)


def digest(collected: Collected) -> str:
    """Changes when anything changes that a mark or its words depend on, but for the time."""
    sum_of = hashlib.sha256()
    for stem, answer in sorted(collected.answers.items()):
        for part in (stem, answer.state, answer.file, answer.words, answer.text):
            raw = part if isinstance(part, bytes) else part.encode()
            sum_of.update(b"%d:" % len(raw) + raw)
    sum_of.update(collected.words.encode())
    return sum_of.hexdigest()
