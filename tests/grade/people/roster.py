"""roster.py - who is in the class: one's own list, or one that a platform writes, as it was downloaded.

    one's own           name, id, login, mail, section   (a name or an id, and any of the others)
    Moodle              participants (First name, Last name, Email address, ID number, Groups), or the grading
                        worksheet (Identifier, Full name, Email address, ...)
    Canvas              gradebook: Student, ID, SIS User ID, SIS Login ID, Section, then assignments
    Gradescope          roster: Name, Email, SID, Sections, Role; or grades: First Name, Last Name, SID, Email, ...
    Blackboard          Last Name, First Name, Username, Student ID, ...
    Brightspace         OrgDefinedId, Username, Last Name, First Name, Email, ...
    GitHub Classroom    identifier, github_username, github_id, name

The headings say what a column is; their order does not matter, and other columns are left alone.
"""
from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from grade.visible import brief
from .sheets import Row, Sheet, SheetError

# What a field is called, by anybody.
HEADINGS = {
    "name": ("name", "full name", "student"),
    "first": ("first name", "given name"),
    "last": ("last name", "surname", "family name"),
    "id": ("id", "sid", "student id", "sis user id", "id number", "orgdefinedid", "student number", "identifier"),
    "login": ("login", "username", "user name", "sis login id"),
    "mail": ("mail", "email", "email address", "e-mail"),
    "section": ("section", "sections", "group", "groups"),
    "github": ("github_username",),
    "role": ("role",),
}
NOT_STUDENTS = re.compile(r"(?!.*student).*(instructor|teacher|ta\b|assistant|reader|observer|designer)", re.IGNORECASE)
FIELDS = ("id", "login", "mail")


@dataclass(frozen=True)
class Person:
    name: str
    id: str = ""
    login: str = ""
    mail: str = ""
    section: str = ""
    github: str = ""
    number: str = ""    # the platform's own: Moodle's participant, Canvas's user
    row: int = 0        # of the sheet

    @property
    def key(self) -> str:
        """What stays the same when somebody is renamed, if there is such a thing."""
        return self.id or self.login or self.mail or self.github or self.name


def kind_of(sheet: Sheet) -> str:
    """Which platform's it is; '' for one's own list and for lists that look like one."""
    heads = {head.casefold() for head in sheet.heading()}
    if "identifier" in heads and "github_username" in heads:
        return "github"
    if {"identifier", "full name"} <= heads:
        return "moodle"
    if {"student", "id"} <= heads and any(head.startswith("sis ") or head == "section" for head in heads):
        return "canvas"
    if {"sid", "email"} <= heads:
        return "gradescope"
    if {"orgdefinedid", "end-of-line indicator"} & heads:
        return "brightspace"
    if {"username", "last name", "first name"} <= heads:
        return "blackboard"
    return ""


def columns_of(sheet: Sheet, kind: str) -> dict:
    """Field -> its column, or None."""
    heads = HEADINGS if kind != "canvas" else {**HEADINGS, "id": ("sis user id",)}
    heads = heads if kind != "moodle" else {**heads, "id": ("id number",)}
    return {field: sheet.column(*names) for field, names in heads.items()}


def turned(name: str) -> str:
    """'Doe, Jane' as people say it."""
    last, comma, first = name.partition(",")
    return f"{first.strip()} {last.strip()}" if comma and first.strip() and "," not in first else name


def number_in(sheet: Sheet, kind: str, row: Row) -> str:
    """The platform's own number of a person, which is also in the names of its downloads."""
    if kind == "moodle":
        match = re.search(r"(\d+)\s*$", sheet.cell(row, sheet.column("identifier")))
        return match[1] if match else ""
    return sheet.cell(row, sheet.column("id")) if kind == "canvas" else ""


def person_in(sheet: Sheet, kind: str, columns: dict, place: int) -> Person | None:
    """Of a row; None for one that is nobody's."""
    row = sheet.rows[place]
    found = {field: sheet.cell(row, column) for field, column in columns.items()}
    if kind == "brightspace":   # which writes #70000, so that no spreadsheet takes it for a number
        found = {field: text.removeprefix("#") for field, text in found.items()}
    number = number_in(sheet, kind, row)
    name = found["name"] or f"{found['first']} {found['last']}".strip()
    if NOT_STUDENTS.fullmatch(found["role"]):
        return None
    if kind == "canvas" and (not number.isdecimal() or name == "Student, Test"):
        return None     # 'Points Possible', and the student that Canvas itself invents
    name = turned(name) or found["login"] or found["id"] or found["mail"] or found["github"]
    if not name:
        if any(cell.strip() for cell in row.cells()):
            raise SheetError(f"{sheet.path}:{row.line}: nobody's name, id, login or mail, expected one of them")
        return None
    return Person(name, found["id"], found["login"], found["mail"], found["section"], found["github"], number, place)


class Roster:
    """people: in the order of the list."""

    def __init__(self, path: Path):
        self.sheet = Sheet(path)
        self.kind = kind_of(self.sheet)
        columns = columns_of(self.sheet, self.kind)
        if all(columns[field] is None for field in ("name", "first", "id", "login", "mail")):
            raise SheetError(f"{path}:1: no column is called name, id, login or mail, expected a list of the class: its "
                             f"headings are {brief(', '.join(self.sheet.heading()))}")
        self.people: list[Person] = []
        before: dict = {}
        for place in range(1, len(self.sheet.rows)):
            person = person_in(self.sheet, self.kind, columns, place)
            if person is None:
                continue
            line = self.sheet.rows[place].line
            for field in (*FIELDS, "github", "number"):
                value = getattr(person, field)
                if value and (other := before.setdefault((field, value.casefold()), line)) != line:
                    raise SheetError(f"{path}:{line}: {field} {brief(value)} is also in line {other}, "
                                     "expected one person for each")
            self.people.append(person)
        if not self.people:
            raise SheetError(f"{path}: nobody is on this list, expected a line for each person")
        keys = [person.key for person in self.people]
        for person in self.people:     # two of one name, and nothing else is known of them
            if keys.count(person.key) > 1:
                raise SheetError(f"{path}:{self.sheet.rows[person.row].line}: {brief(person.name)} is there twice, "
                                 "expected an id, a login or a mail to tell them apart")

    def titles(self) -> dict:
        """Key -> the name as reports show it: with more where two have the same."""
        names = [person.name.casefold() for person in self.people]
        return {person.key: person.name if names.count(person.name.casefold()) == 1 else f"{person.name} ({person.key})"
                for person in self.people}

