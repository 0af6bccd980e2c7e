"""platforms.py - a class of 300 as each learning platform exports it: its list and grade file, and its download, made by
their documents (not by the code that reads them). Two have one name, some were renamed, some handed in late, again, or nothing.
"""
from __future__ import annotations

import random
from dataclasses import dataclass, field

FIRST = "Anna Ben Chloë Dmitri Élise Farid Grace Hüseyin Ingrid Jürgen Kim Łukasz Mei Nuño Oksana".split()
LAST = "Abel Baker Çelik Dvořák Eriksson Fischer García Hansen Ivanov Jones Kowalski Li Müller Nguyễn O'Neill Öz Pérez Quist " \
       "Rossi Smith".split()


@dataclass
class Student:
    first: str
    last: str
    id: str
    login: str
    number: int                     # the platform's own
    late: bool = False
    texts: list = field(default_factory=list)    # of 01-corners.c, in the order in which they were handed in; [] nothing
    name_then: str = ""             # in the download, if renamed since

    @property
    def name(self) -> str:
        return f"{self.first} {self.last}"

    @property
    def mail(self) -> str:
        return f"{self.login}@example.org"

    @property
    def answer(self) -> bytes:
        """What counts; b'' of who handed in nothing."""
        return self.texts[-1] if self.texts else b""


def students(size: int = 300) -> list:
    chance = random.Random(7)
    them = [Student(FIRST[at % 15], LAST[at // 15 % 20], f"{70000 + at}", f"u{at:03}x", 4000 + 7 * at) for at in range(size)]
    them[1].first, them[1].last = them[0].first, them[0].last       # two of one name
    for at, one in enumerate(them):
        times = 0 if at % 10 == 9 else chance.choice([1, 1, 1, 2, 3])
        one.texts = [f"// {one.id}, {again}\n".encode() for again in range(times)]
        one.late = at % 6 == 5
    return them


def quoted(*cells: str) -> str:
    return ",".join('"' + cell.replace('"', '""') + '"' if set(cell) & set(' ,"') else cell for cell in cells)


# ---- downloads: name -> bytes; renamed: whether names may have changed since ------------------------


def moodle(them: list) -> dict:
    return {f"{one.name_then or one.name}_{one.number}_assignsubmission_file_/01-corners.c": one.answer
            for one in them if one.texts}


def moodle_loose(them: list) -> dict:
    return {f"{one.name_then or one.name}_{one.number}_assignsubmission_file_01-corners.c": one.answer for one in them if one.texts}


def canvas(them: list) -> dict:
    files = {}
    for one in them:
        who = "".join(letter for letter in (one.last + one.first).lower() if letter.isalpha())
        for again, text in enumerate(one.texts):
            ending = f"01-corners-{again}.c" if again else "01-corners.c"
            files[f"{who}{'_LATE' * one.late}_{one.number}_{9000 + 5 * one.number + again}_{ending}"] = text
    return files


def gradescope(them: list) -> dict:
    files, lines = {}, ["---"]
    for one in them:
        if one.texts:
            files[f"submission_{800 + one.number}/01-corners.c"] = one.answer
            lines += [f"submission_{800 + one.number}:", "  :submitters:", f"  - :name: '{(one.name_then or one.name).replace(chr(39), chr(39) * 2)}'",
                      f"    :sid: '{one.id}'", f"    :email: {one.mail}", "  :score: 0.0"]
    return {**files, "submission_metadata.yml": "\n".join(lines).encode() + b"\n"}


def blackboard(them: list) -> dict:
    files = {}
    for one in them:
        for again, text in enumerate(one.texts):
            attempt = f"Week 1_{one.login}_attempt_2025-11-1{again + 3}-23-59-0{again}"
            files.update({f"{attempt}_01-corners.c": text, f"{attempt}.txt": f"Name: {one.name} ({one.login})".encode()})
    return files


def brightspace(them: list) -> dict:
    files = {"index.html": b"<html></html>"}
    for one in them:
        for again, text in enumerate(one.texts):
            files[f"{one.number}-5511 - {one.name} - Nov {again + 13}, 2025 {['859 AM', '1159 PM', '1201 AM'][again]}/01-corners.c"] = text
    return files


def ilias(them: list) -> dict:
    return {f"Week 1/{one.last}_{one.first}_{one.login}_{one.number}/01-corners.c": one.answer for one in them if one.texts}


def github(them: list) -> dict:
    return {f"week-1-{one.login}-hub/exercises/01-corners.c": one.answer for one in them if one.texts}


def own(them: list) -> dict:
    """Folders that students have named: by id, login, name."""
    names = [lambda one: one.id, lambda one: one.login, lambda one: one.mail, lambda one: f"{one.last}, {one.first}"]
    return {f"{names[at % 4 if at > 3 else 0](one)}/01-corners.c": one.answer for at, one in enumerate(them) if one.texts}


# ---- lists and grade files --------------------------------------------------------------------------


def moodle_worksheet(them: list) -> bytes:
    lines = [quoted("Identifier", "Full name", "Email address", "Status", "Grade", "Maximum grade", "Grade can be changed",
                    "Last modified (submission)", "Last modified (grade)", "Feedback comments")]
    lines += [quoted(f"Participant {one.number}", one.name, one.mail, "Submitted for grading" if one.texts else "No submission", "",
                     "10.00", "Yes", "Friday, 14 November 2025, 9:00 PM", "-", "") for one in them]
    return b"\xef\xbb\xbf" + "\r\n".join(lines).encode() + b"\r\n"


def moodle_participants(them: list) -> bytes:
    lines = ["First name,Last name,ID number,Email address,Groups"]
    return "\n".join(lines + [quoted(one.first, one.last, one.id, one.mail, "Group A") for one in them]).encode()


def canvas_gradebook(them: list) -> bytes:
    lines = ["Student,ID,SIS User ID,SIS Login ID,Section,Week 1 (77),Week 2 (78),Final Score", "    Points Possible,,,,,10,10,(read only)"]
    lines += [quoted(f"{one.last}, {one.first}", str(one.number), one.id, one.login, "Monday", "", "", "") for one in them]
    return "\n".join([*lines, '"Student, Test",99999,,,Monday,,,']).encode() + b"\n"


def gradescope_roster(them: list) -> bytes:
    lines = ["Name,Email,SID,Sections,Role", 'Prof,prof@example.org,,,Instructor']
    return "\n".join(lines + [quoted(one.name, one.mail, one.id, "Monday", "Student") for one in them]).encode()


def gradescope_grades(them: list) -> bytes:
    lines = ["First Name,Last Name,SID,Email,Sections,Week 1,Week 1 - Max Points,Week 1 - Lateness (H:M:S)"]
    return "\n".join(lines + [quoted(one.first, one.last, one.id, one.mail, "Monday", "", "10.0", "00:00:00") for one in them]).encode()


def blackboard_column(them: list) -> bytes:
    lines = ['"Last Name"\t"First Name"\t"Username"\t"Student ID"\t"Last Access"\t"Availability"\t"Week 1 [Total Pts: 10 Score] |1234"']
    lines += ["\t".join(f'"{cell}"' for cell in (one.last, one.first, one.login, one.id, "2025-11-14 10:00:00", "Yes", "")) for one in them]
    return b"\xff\xfe" + "\r\n".join(lines).encode("utf-16-le")


def brightspace_grades(them: list) -> bytes:
    lines = ["OrgDefinedId,Username,Last Name,First Name,Email,Week 1 Points Grade <Numeric MaxPoints:10>,End-of-Line Indicator"]
    return "\n".join(lines + [quoted(f"#{one.id}", f"#{one.login}", one.last, one.first, one.mail, "", "#") for one in them]).encode()


def github_roster(them: list) -> bytes:
    lines = ['"identifier","github_username","github_id","name"']
    return "\n".join(lines + [f'"{one.id}","{one.login}-hub","{one.number}",""' for one in them]).encode()


def own_list(them: list) -> bytes:
    return "\n".join(["name,id,login,mail,section"] + [quoted(one.name, one.id, one.login, one.mail, "A") for one in them]).encode()


# Platform -> its list, its download; whether the download tells people of one name apart, and knows who was renamed.
PLATFORMS = {
    "Moodle's worksheet": (moodle_worksheet, moodle, True),
    "Moodle, files without folders": (moodle_worksheet, moodle_loose, True),
    "Moodle's participants": (moodle_participants, moodle, False),
    "Canvas": (canvas_gradebook, canvas, True),
    "Gradescope's roster": (gradescope_roster, gradescope, True),
    "Gradescope's grades": (gradescope_grades, gradescope, True),
    "Blackboard": (blackboard_column, blackboard, True),
    "Brightspace": (brightspace_grades, brightspace, False),
    "ILIAS": (own_list, ilias, True),
    "GitHub Classroom": (github_roster, github, True),
    "one's own list and folders": (own_list, own, True),
    "one's own list, Moodle's download": (own_list, moodle, False),
}
