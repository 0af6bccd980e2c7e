"""exports.py - what learning platforms export, as they export it: which entries are one person's.

    Canvas      doejane_123_456_01-corners.c      loose files: who, user, upload, name; _LATE after
                doejane_LATE_123_457_hw-1.zip     who; -1, -2 ... before the suffix if handed in again
    Moodle      Jane Doe_123_assignsubmission_file_/     a folder for each, or with 'folders' off
                Jane Doe_123_assignsubmission_file_NAME  loose files
    Gradescope  submission_123/               a folder for each; submission_metadata.yml has the names

Everything else is a submission under its own name: folders (a clone of GitHub Classroom's is one),
archives, and loose files, which hold no answer but whose owner has handed in something.
"""
from __future__ import annotations

import os
import re
from collections import Counter, defaultdict
from dataclasses import dataclass, replace

from .limits import opened_file
from .names import decoded

CANVAS = re.compile(r"(?P<who>.+?)(?:_LATE)?_(?P<user>\d{1,18})_(?P<upload>\d{1,18})_(?P<name>.+)", re.ASCII | re.DOTALL)
MOODLE = re.compile(r"(?P<who>.+?)_(?P<user>\d{1,18})_assignsubmission_[a-z]+(?:_(?P<name>.*))?", re.ASCII | re.DOTALL)
AGAIN = re.compile(r"(?P<name>.+)-(?P<time>\d{1,4})\.c", re.ASCII | re.DOTALL)
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


def of_canvas(found: dict) -> dict:
    """The matches that are Canvas's, and not names that happen to look like that: an upload has one
    number, a user one name, and archives of one user alone are rather ws_2025_1_anna.zip."""
    uploads = Counter(match["upload"] for match, _ in found.values())
    users = Counter(user for user, _ in {(match["user"], match["who"]) for match, _ in found.values()})
    if len(found) > 1 and len(users) == 1 and all(kind == "archive" for _, kind in found.values()):
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
            part = replace(part, upload=int(match["upload"]))
        if match is None:
            owners[raw].append(part)
        else:
            owner = f"{match['who']}_{match['user']}".encode("utf-8", "surrogateescape")
            owners[owner].append(replace(part, name=match["name"] or ""))
    return [Owner(raw, tuple(newest(parts))) for raw, parts in owners.items()]


def newest(parts: list) -> list:
    """Canvas calls a file 01-corners-1.c that is handed in again. The upload that came last counts,
    under the name that it was handed in with."""
    kept: dict = {}
    for part in sorted(parts, key=lambda part: part.upload):
        again = AGAIN.fullmatch(part.name) if part.upload else None
        name = f"{again['name']}.c" if again else part.name
        kept[name if part.upload and part.kind == "file" else part.path] = replace(part, name=name)
    return sorted(kept.values(), key=lambda part: part.path)


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
    names, taken = people(directory), {decoded(owner.raw) for owner in owners}
    for owner in owners:
        folder = decoded(owner.raw)
        them = names.get(folder, [])
        more = f" and {len(them) - NAMED} more" if len(them) > NAMED else ""
        title = f"{', '.join(them[:NAMED])}{more} ({folder})" if them else folder
        if title in taken:
            title = folder
        taken.add(title)
        yield replace(owner, title=title)
