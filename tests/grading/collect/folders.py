"""folders.py - looks for answers in a folder that somebody else made.

Each folder is reached from the submission's own by one openat after the other, none of which
follows a symbolic link: no link, and no race with one, leads out. Breadth first, in the order of
names, so that what is found does not depend on the machine, and answers are found before clutter.
"""
import os
import stat
from collections import deque
from itertools import islice

from visible import why
from . import answers
from .names import decoded

ENTRIES = 20000
DEPTH = 50
TOTAL = 64 * 1024 * 1024  # bytes read, of all answers together
DIRECTORY = os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC
# Should it have become a fifo since it was looked at, opening it must not wait.
FILE = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_NOCTTY | os.O_CLOEXEC


class Enough(Exception):
    """Nothing more is looked at; the words say why."""


def opened_file(name, folder=None):
    """A regular file; OSError where it is something else."""
    file = open(os.open(name, FILE, dir_fd=folder), "rb")
    if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
        file.close()
        raise OSError(0, "it is not a file")
    return file


def read(name, folder=None) -> tuple:
    """A regular file's bytes, one more than an answer may have, and when it was written."""
    with opened_file(name, folder) as file:
        return file.read(answers.LARGEST + 1), int(os.fstat(file.fileno()).st_mtime)


def opened_folder(root: int, parts) -> int:
    folder = os.dup(root)
    for part in parts:
        try:
            below = os.open(part, DIRECTORY, dir_fd=folder)
        finally:
            os.close(folder)
        folder = below
    return folder


def look_at(search, folder: int, parts, entry) -> int:
    """One entry that is no folder; how many bytes were read of it."""
    if not answers.stem_of(search, parts[-1]):
        answers.bystander(search, parts)
        return 0
    if entry.is_symlink():
        answers.no_file(search, parts, answers.NOT_FOLLOWED)
    elif not entry.is_file(follow_symlinks=False):
        answers.no_file(search, parts, "neither a file nor a folder, not opened")
    else:
        try:
            raw, when = read(entry.name, folder)
        except OSError as error:
            answers.unreadable(search, parts, f"cannot be read: {why(error)}")
            return 0
        search.when = max(search.when or when, when)
        answers.found(search, parts, raw)
        return len(raw)
    return 0


def look_in(search, folder: int, parts, left: dict) -> list:
    """All entries of one folder; the folders among them."""
    with os.scandir(folder) as listing:
        here = list(islice(listing, left["entries"] + 1))
    # All of a folder or nothing: which of its entries come first is chance.
    left["entries"] -= len(here)
    if left["entries"] < 0:
        raise Enough(f"holds more than {ENTRIES} entries; no more were looked at")
    below = []
    for entry in sorted(here, key=lambda entry: os.fsencode(entry.name)):
        name = os.fsencode(entry.name)
        if name == b"__MACOSX":
            continue
        if entry.is_dir(follow_symlinks=False):
            below.append(parts + (name,))
            continue
        left["bytes"] -= look_at(search, folder, [*map(decoded, parts), decoded(name)], entry)
        if left["bytes"] < 0:
            raise Enough(f"holds more than {TOTAL >> 20} MB of answers; no more were read")
    return below


def look(search, path: bytes) -> None:
    root = os.open(path, DIRECTORY)
    waiting = deque([()])
    left = {"entries": ENTRIES, "bytes": TOTAL}
    try:
        while waiting:
            parts = waiting.popleft()
            if len(parts) > DEPTH:
                raise Enough(f"holds folders more than {DEPTH} deep; those were not looked at")
            try:
                folder = opened_folder(root, parts)
                try:
                    waiting.extend(look_in(search, folder, parts, left))
                finally:
                    os.close(folder)
            except OSError as error:
                place = answers.place_of(map(decoded, parts)) or "the folder"
                answers.note(search, f"{place} cannot be read: {why(error)}")
    except Enough as enough:
        answers.ended_early(search, str(enough))
    finally:
        os.close(root)
