"""platforms.py - what learning platforms export: whose each entry of a class's folder is, and which of several attempts.

    Canvas        doejane_123_456_01-corners.c      loose files: who, user, upload, name; _LATE after
                  doejane_LATE_123_457_hw-1.zip     who; -1, -2 ... before the suffix if handed in again
                  anon_Xy12z_456_01-corners.c       the same without names
    Moodle        Jane Doe_123_assignsubmission_file_/     a folder for each, or with 'folders' off
                  Jane Doe_123_assignsubmission_file_NAME  loose files
    Gradescope    submission_123/                   a folder for each; submission_metadata.yml has the names
    Blackboard    HW 1_jdoe_attempt_2025-11-14-23-59-59_01-corners.c    loose files, and a .txt for each attempt
    Brightspace   1234-5678 - Jane Doe - Nov 14, 2025 1159 PM/          a folder for each attempt
    ILIAS         Doe_Jane_jdoe_123/                a folder for each, in a folder of the exercise
    GitHub        week-1-octocat/                   a clone for each

What an entry claims of its owner is compared with the list of the class elsewhere (people/matching.py).
"""
from __future__ import annotations

import os
import re
from collections import Counter, defaultdict
from dataclasses import dataclass, replace
from datetime import datetime
from typing import Optional

from grade.visible import several
from .names import decoded
from .streams import opened_file

CANVAS = re.compile(r"(?P<who>.+?)(?:_LATE)?_(?P<user>\d{1,18})_(?P<upload>\d{1,18})_(?P<name>.+)",
                    re.ASCII | re.DOTALL)
ANONYMOUS = re.compile(r"anon_(?P<user>[A-Za-z0-9]{3,20})(?:_LATE)?_(?P<upload>\d{1,18})_(?P<name>.+)", re.ASCII | re.DOTALL)
MOODLE = re.compile(r"(?P<who>.+?)_(?P<user>\d{1,18})_assignsubmission_[a-z]+(?:_(?P<name>.*))?", re.ASCII | re.DOTALL)
BLACKBOARD = re.compile(r"(?P<who>.+_.+)_attempt_(?P<time>\d{4}(?:-\d\d){5})(?:_(?P<name>.+)|\.txt)", re.ASCII | re.DOTALL)
BRIGHTSPACE = re.compile(r"(?P<user>\d{1,18}-\d{1,18}) - (?P<who>.+) - (?P<time>[A-Z][a-z]{2} \d{1,2}, \d{4} \d{3,4} [AP]M)",
                         re.ASCII | re.DOTALL)
ILIAS = re.compile(r"(?P<last>[^_]+)_(?P<first>[^_]+)_(?P<login>[^_]+)_(?P<user>\d{1,18})", re.ASCII | re.DOTALL)
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
    when: Optional[int] = None  # as the platform says it, in seconds since 1970

    @property
    def said(self) -> str:
        """Which upload it is, in words."""
        return f"{datetime.fromtimestamp(self.when):%Y-%m-%d %H:%M}" if self.when is not None else f"upload {self.upload}"


@dataclass(frozen=True)
class Claim:
    """What an entry says of one of its owners; '' where it says nothing."""
    number: str = ""        # the platform's
    id: str = ""
    login: tuple = ()       # it is one of these
    mail: str = ""
    name: str = ""
    text: str = ""          # an entry that no platform has named


@dataclass(frozen=True)
class Owner:
    """Whose parts these are, as the class's folder says it."""
    raw: bytes
    parts: tuple
    title: str = ""     # as people read it
    claims: tuple = ()  # a group has several


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


def seconds(time: str, form: str) -> Optional[int]:
    """A platform's time has no zone: it is taken for this machine's."""
    try:
        return int(datetime.strptime(time, form).timestamp())
    except (ValueError, OverflowError, OSError):
        return None


def column_of(whos: set) -> int:
    """How long the name of Blackboard's column is, which comes before each user's, with its _."""
    common = os.path.commonprefix(sorted(whos)) if len(whos) > 1 else next(iter(whos), "")
    return common.rindex("_") + 1 if "_" in common else 0


class Reader:
    """What the names of a folder's entries say. Some of it depends on all of them."""

    def __init__(self, entries: list):
        """entries: (Part, its name's bytes)."""
        files = [(part, raw) for part, raw in entries if part.kind in ("archive", "file")]
        self.blackboard = {raw: match for part, raw in files if (match := BLACKBOARD.fullmatch(decoded(raw)))}
        self.column = column_of({match["who"] for match in self.blackboard.values()})
        self.canvas = of_canvas({raw: (match, part.kind) for part, raw in files if raw not in self.blackboard
                                 and (match := matched(CANVAS, raw, part.kind))})

    def read(self, part: Part, raw: bytes) -> Optional[tuple]:
        """(the owner's bytes, the part, the claim); None for an entry that no platform has named."""
        if match := self.blackboard.get(raw):
            when, who = seconds(match["time"], "%Y-%m-%d-%H-%M-%S"), match["who"].split("_")
            part = replace(part, name=match["name"] or "what was written.txt", when=when,
                           upload=int(match["time"].replace("-", "")))
            return match["who"][self.column:], part, Claim(login=tuple("_".join(who[at:]) for at in range(1, len(who))))
        if match := matched(MOODLE, raw, part.kind):
            return (f"{match['who']}_{match['user']}", replace(part, name=match["name"] or ""),
                    Claim(number=match["user"], name=match["who"]))
        if match := self.canvas.get(raw):
            part = replace(part, upload=int(match["upload"]), name=handed_in_as(match["name"]))
            return f"{match['who']}_{match['user']}", part, Claim(number=match["user"], name=match["who"])
        if part.kind in ("archive", "file") and (match := matched(ANONYMOUS, raw, part.kind)):
            part = replace(part, upload=int(match["upload"]), name=handed_in_as(match["name"]))
            return f"anon_{match['user']}", part, Claim(text=f"anon_{match['user']}")
        if part.kind == "folder" and (match := BRIGHTSPACE.fullmatch(decoded(raw))):
            when = seconds(re.sub(r" (\d\d\d [AP]M)$", r" 0\1", match["time"]), "%b %d, %Y %I%M %p")
            return f"{match['who']}_{match['user']}", replace(part, upload=when or 0, when=when), Claim(name=match["who"])
        if part.kind == "folder" and (match := ILIAS.fullmatch(decoded(raw))):
            return decoded(raw), part, Claim(login=(match["login"],), name=f"{match['first']} {match['last']}")
        return None


def grouped(entries: list) -> list:
    """entries: (Part, its name's bytes). The owners, in the order of their first entries."""
    reader = Reader(entries)
    owners, claims = defaultdict(list), {}
    for part, raw in entries:
        who, part, claim = reader.read(part, raw) or (decoded(raw), part, Claim(text=decoded(raw)))
        owner = who.encode("utf-8", "surrogateescape")
        owners[owner].append(part)
        claims.setdefault(owner, (claim,))
    return [Owner(raw, tuple(parts), claims=claims[raw]) for raw, parts in owners.items()]


def are_all_named(entries: list) -> bool:
    """By a platform: then the folder that they lie in is none of a student's."""
    reader = Reader(entries)
    return bool(entries) and all(reader.read(part, raw) or re.fullmatch(rb"submission_\d+", raw) for part, raw in entries)


# ---- Gradescope's names -------------------------------------------------------------------------

def unquoted(text: str) -> str:
    text = text.strip()
    return text[1:-1].replace("''", "'") if len(text) > 1 and text[0] == text[-1] and text[0] in "'\"" else text


def people(directory: bytes) -> dict:
    """Folder -> those who handed it in, as dicts of name, sid and email, from Gradescope's list; {} without one."""
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
        elif inside and folder and (match := re.fullmatch(r"\s+(- +)?:?(name|sid|email): +(.+)", line)):
            if match[1] or not found[folder]:
                found[folder].append({})
            found[folder][-1][match[2]] = unquoted(match[3])
    return found


def titled(owners: list, directory: bytes) -> list:
    """With the names of people, where the platform has a list of them."""
    known, taken = people(directory), {decoded(owner.raw) for owner in owners}
    for owner in owners:
        folder = decoded(owner.raw)
        group = known.get(folder, [])
        claims = tuple(Claim(id=one.get("sid", ""), mail=one.get("email", ""), name=one.get("name", "")) for one in group)
        them = [one["name"] for one in group if one.get("name")]
        title = f"{several(them, NAMED)} ({folder})" if them else folder
        if title in taken:
            title = folder
        taken.add(title)
        yield replace(owner, title=title, claims=claims or owner.claims)
