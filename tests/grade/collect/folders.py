"""folders.py - looks for answers in a folder that somebody else made.

Each folder is reached from the submission's own by one openat after the other, none of which
follows a symbolic link: no link, and no race with one, leads out. Breadth first, in the order of
names, so that what is found does not depend on the machine, and answers are found before clutter.
Archives in it are read as they are met, and opened when all folders have been looked at.
"""
import os
from collections import deque
from itertools import islice

from grade.confine.machine import must_be_its_own
from grade.visible import why
from . import answers, archives
from .streams import Enough, opened_file
from .names import decoded

DEPTH = 50
DIRECTORY = os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC
NOT_LOOKED_AT = (b"__MACOSX", b".git")


def read(name, folder=None, most=answers.LARGEST) -> tuple:
    """A regular file's bytes, one more than it may have, and when it was written."""
    with opened_file(name, folder) as file:
        return file.read(most + 1), int(os.fstat(file.fileno()).st_mtime)


def opened_folder(root: int, parts) -> int:
    folder = os.dup(root)
    for part in parts:
        try:
            below = os.open(part, DIRECTORY, dir_fd=folder)
        finally:
            os.close(folder)
        folder = below
    return folder


def put_by(search, folder: int, parts, entry, room) -> None:
    """An archive among the files: read now, opened later."""
    if entry.is_symlink() or not entry.is_file(follow_symlinks=False):
        return
    try:
        raw, when = read(entry.name, folder, max(room.kept, 0))
    except OSError as error:
        answers.not_read(search, f"{answers.place_of(parts)} cannot be read: {why(error)}")
        return
    if archives.put_by(search, room, parts, raw, 1):
        answers.written(search, when)


def look_at(search, folder: int, parts, entry, room) -> None:
    """One entry that is not a folder."""
    if not answers.stem_of(search, parts[-1]):
        answers.passed(search, parts)
        if archives.is_called_one(parts[-1]):
            put_by(search, folder, parts, entry, room)
        answers.bystander(search, parts)
    elif entry.is_symlink():
        answers.no_file(search, parts, answers.NOT_FOLLOWED)
    elif not entry.is_file(follow_symlinks=False):
        answers.no_file(search, parts, "neither a file nor a folder, not opened")
    else:
        try:
            raw, when = read(entry.name, folder)
        except OSError as error:
            answers.unreadable(search, parts, f"cannot be read: {why(error)}")
            return
        answers.found(search, parts, raw)
        if not answers.is_toolkit_s(search, parts):
            answers.written(search, when)
        room.keep(len(raw))


def look_in(search, folder: int, parts, room) -> list:
    """All entries of one folder; the folders among them."""
    with os.scandir(folder) as listing:
        here = list(islice(listing, room.entries + 1))
    # All of a folder or nothing: which of its entries come first is chance.
    room.look_at(len(here))
    below = []
    for entry in sorted(here, key=lambda entry: os.fsencode(entry.name)):
        name = os.fsencode(entry.name)
        if name in NOT_LOOKED_AT:
            continue
        if entry.is_dir(follow_symlinks=False):
            below.append(parts + (name,))
            continue
        look_at(search, folder, [*map(decoded, parts), decoded(name)], entry, room)
    # Where exercises/ are, its neighbours may be the toolkit's own, which are not looked at.
    return sorted(below, key=lambda path: path[-1] != b"exercises")


def look(search, path: bytes, opener=None) -> None:
    root = os.open(path, DIRECTORY)
    waiting = deque([()])
    room = archives.Room(opener)
    try:
        while waiting:
            parts = waiting.popleft()
            if answers.is_toolkit_s(search, list(map(decoded, parts))):
                continue
            if len(parts) > DEPTH:
                raise Enough(f"holds folders more than {DEPTH} deep; those were not looked at")
            try:
                folder = opened_folder(root, parts)
                try:
                    waiting.extend(look_in(search, folder, parts, room))
                finally:
                    os.close(folder)
            except OSError as error:
                must_be_its_own(error)
                place = answers.place_of(map(decoded, parts)) or "the folder"
                answers.not_read(search, f"{place} cannot be read: {why(error)}")
        archives.look_in_waiting(search, room)
    except Enough as enough:
        answers.ended_early(search, str(enough))
    finally:
        os.close(root)
