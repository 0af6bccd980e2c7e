"""hand_back.py - make return: the pages for the students and the marks for the grade book, as a platform takes them.

    hand_back.py, and settings in the environment: FOR, GRADES, COLUMN, SCALE; SUBMISSIONS, CLASS, LEDGER, OUT

    FOR=moodle      feedback.zip, for 'Upload multiple feedback files in a zip'; GRADES: the grading worksheet
    FOR=canvas      feedback.zip, for 'Upload Submissions'; GRADES: the exported gradebook
    FOR=gradescope  GRADES: the grades as downloaded; the autograder has shown the pages already
    FOR=blackboard  pages to attach by hand; GRADES: the column file, with 'Feedback to Learner' if it was downloaded so
    FOR=folder      a page for each student, and mail.csv: who gets which

All of it goes into OUT/return/FOR. GRADES is not changed: a copy of it is, in the cells of mark and comment alone.
What is returned is what 'make grade' has written; nothing is marked here.
"""
from __future__ import annotations

import html
import io
import os
import re
import zipfile
from fractions import Fraction
from pathlib import Path

from grade import exercises
from grade.collect.names import decoded
from grade.collect.platforms import CANVAS, MOODLE, Claim
from grade.people.history import members
from grade.people.ledger import Ledger, read_ledger
from grade.people.matching import Finder, class_of
from grade.people.roster import Roster
from grade.people.sheets import Sheet, SheetError
from grade.policy import rounded
from grade.report.files import put, read_record
from grade.report.formats import mark, table
from grade.report.points import NOTHING, reason
from grade.settings import as_last_time, stop
from grade.visible import brief, number, several, visible, why

PLATFORMS = ("moodle", "canvas", "gradescope", "blackboard", "folder")
PAGE = "feedback.html"
NAMED = 20      # of a list of people
ASSIGNMENTS = {"canvas": r".+ \(\d+\)", "blackboard": r".+\[Total Pts: .*\].*\|\d+"}   # the only columns that marks may go into


class Returned:
    """Somebody's result, and what a platform knows them by."""

    def __init__(self, submission, record: dict, page: bytes):
        self.submission, self.record, self.page = submission, record, page

    def claims(self) -> list:
        person = self.record["person"]
        said = [Claim(number=claim.number) for claim in self.submission.claims if claim.number]
        return said + [Claim(id=person.get("id", ""), login=(person.get("login", ""),), mail=person.get("mail", ""),
                             name=person.get("name", ""))] if person else said + list(self.submission.claims)

    def comment(self) -> str:
        marks = f"{number(self.record['score'])} of {number(self.record['max'])}" if self.record["score"] is not None \
            else self.record["status"]
        chapters = ", ".join(f"{stem['stem']} {number(stem['score'])}" for stem in self.record["stems"] if stem["max"])
        return "; ".join(filter(None, (marks + (f" ({chapters})" if chapters else ""), reason(self.record))))


def listed(names: list) -> str:
    return f"{len(names)}, {several(list(map(brief, names)), NAMED)}"


def results(class_list, out: Path, ledger: Ledger) -> list:
    """Everybody's, as the reports of the class had them."""
    known, found = members(out), []
    if not known:
        stop(f"OUT={out} holds no marks: run 'make grade' first, with the same settings")
    for submission in class_list.found:
        if submission.folder not in known:
            stop(f"{submission.name} has no mark yet: run 'make grade' first, with the same settings")
        if [visible(one.words()) for one in ledger.of(submission.key).all] != known[submission.folder]["decided"]:
            stop(f"the ledger says something else of {submission.name} than their mark: run 'make grade' first")
        if known[submission.folder]["status"] == NOTHING:
            record = {**known[submission.folder], "stems": [], "unlisted": "", "words": "", "late": ""}
            found.append(Returned(submission, record, b""))
            continue
        folder = out / submission.folder
        found.append(Returned(submission, read_record(str(folder / "results.json")), (folder / "index.html").read_bytes()))
    return found


# ---- pages --------------------------------------------------------------------------------------


def moodle_name(returned: Returned) -> str | None:
    """As its download had it, which is how Moodle finds the student."""
    for part in returned.submission.parts:
        if match := MOODLE.fullmatch(decoded(os.path.basename(part.path))):
            whole = match[0] if match["name"] is None or part.kind == "folder" else match[0][:match.start("name")]
            return f"{whole.rstrip('/')}/{PAGE}" if part.kind == "folder" else whole + PAGE
    return None


def canvas_name(returned: Returned) -> str | None:
    """Of the last file that was handed in."""
    names = [(part.upload, match) for part in returned.submission.parts
             if (match := CANVAS.fullmatch(decoded(os.path.basename(part.path))))]
    match = max(names, key=lambda pair: pair[0])[1] if names else None
    return match[0][:match.start("name")] + PAGE if match else None


def zipped(pages: dict) -> bytes:
    memory = io.BytesIO()
    with zipfile.ZipFile(memory, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, page in pages.items():
            member = zipfile.ZipInfo(name)  # of 1980: the same pages make the same bytes
            member.external_attr = 0o100644 << 16
            member.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(member, page)
    return memory.getvalue()


def pages_for(platform: str, everybody: list, folder: Path) -> str:
    """Writes them; what was written, in words."""
    pages = [returned for returned in everybody if returned.page]
    if platform in ("moodle", "canvas"):
        name_of = moodle_name if platform == "moodle" else canvas_name
        named = {name: returned.page for returned in pages if (name := name_of(returned))}
        put(str(folder), "feedback.zip", zipped(named))
        others = [returned.record["submission"] for returned in pages if not name_of(returned)]
        if others:
            print(f"No page for those whose submission is not called as {platform} calls it: {listed(others)}")
        return f"feedback.zip, {len(named)} pages"
    if platform == "gradescope":
        return ""
    rows = [["page", "name", "mail", "final", "max"]]
    for returned in pages:
        name = f"{returned.submission.folder}.html"
        put(str(folder), name, returned.page)
        person = returned.record["person"]
        rows.append([name, returned.record["submission"], person.get("mail", ""), mark(returned.record["score"]),
                     mark(returned.record["max"])])
    put(str(folder), "mail.csv", table(rows))
    return f"{len(pages)} pages, mail.csv"


# ---- marks --------------------------------------------------------------------------------------


def column_named(sheet: Sheet, kind: str, wanted: str) -> int:
    """Of the marks."""
    heads = sheet.heading()
    if kind == "moodle" and not wanted:
        wanted = "Grade"
    if wanted:
        found = [place for place, head in enumerate(heads) if wanted.casefold() in (head.casefold(), re.sub(
            r" (\(\d+\)|\[Total Pts.*)$", "", head).casefold())]
        found = [place for place in found if re.fullmatch(ASSIGNMENTS.get(kind, r".*"), heads[place])]
    else:
        found = [place for place, head in enumerate(heads) if re.fullmatch(ASSIGNMENTS.get(kind, r"(?!)"), head)]
    if len(found) != 1:
        raise SheetError(f"{sheet.path}:1: {len(found)} columns may be for these marks, expected COLUMN='...' with one of the "
                         f"headings: {brief(', '.join(heads), 600)}")
    return found[0]


def most_in(sheet: Sheet, kind: str, column: int) -> Fraction | None:
    """The most that the platform lets a mark be; None if it does not say."""
    text = ""
    if kind == "moodle" and len(sheet.rows) > 1:
        text = sheet.cell(sheet.rows[1], sheet.column("Maximum grade"))
    elif kind == "canvas":
        text = next((sheet.cell(row, column) for row in sheet.rows[1:] if sheet.cell(row, 0).startswith("Points Possible")), "")
    elif kind == "blackboard":
        match = re.search(r"\[Total Pts: (?:up to )?([\d.,]+)", sheet.heading()[column])
        text = match[1] if match else ""
    try:
        return Fraction(text.replace(",", ".")) or None
    except ValueError:
        return None


def factors(sheet: Sheet, kind: str, column: int, everybody: list, scale: bool) -> dict:
    """The most that somebody can have -> what to multiply their mark with. Whoever is excused from a chapter can have
    less, and has as large a part of the whole."""
    mosts = {Fraction(str(returned.record["max"])) for returned in everybody}
    most = max(mosts, default=Fraction(0))
    theirs = most_in(sheet, kind, column)
    if theirs is not None and theirs != most and most and not scale:
        raise SheetError(f"{sheet.path}: its marks are of {number(float(theirs))}, and these of {number(float(most))}: "
                         "change the points in the policy, or say SCALE=1 to have them converted")
    return {one: (theirs or most) / one if one else Fraction(1) for one in mosts}


def fill(grades: Path, platform: str, everybody: list, wanted: str, scale: bool) -> tuple:
    """The sheet with the marks in it; and words about those who are only in one of the two."""
    roster = Roster(grades)
    sheet, finder = roster.sheet, Finder(roster.people)
    column = column_named(sheet, platform, wanted)
    times = factors(sheet, platform, column, everybody, scale)
    comments = sheet.column("Feedback comments", "Feedback to Learner")
    fixed = sheet.column("Grade can be changed")
    done, lacking, unchanged = set(), [], []
    for returned in everybody:
        found = next((people for claim in returned.claims() if len(people := finder.find(claim)) == 1), [])
        name = returned.record["submission"]
        if not found or found[0].row in done:
            lacking.append(name)
            continue
        row = sheet.rows[found[0].row]
        done.add(found[0].row)
        if fixed is not None and sheet.cell(row, fixed).casefold() == "no":
            unchanged.append(name)
            continue
        score, most = returned.record["score"], Fraction(str(returned.record["max"]))
        sheet.fill(row, column, mark(None if score is None else rounded(Fraction(str(score)) * times[most])))
        if comments is not None:
            text = returned.comment()
            sheet.fill(row, comments, html.escape(text, quote=False) if platform == "moodle" else text)
    rest = [person.name for person in roster.people if person.row not in done]
    words = [f"{what}: {listed(who)}" for what, who in
             ((f"Not in {grades.name}", lacking), (f"Only in {grades.name}, left as they are", rest),
              ("The platform says that these marks cannot be changed", unchanged)) if who]
    return sheet, words


def main() -> None:
    def setting(name: str, otherwise: str = "") -> str:
        return os.environ.get(name) or otherwise

    platform, out = setting("FOR"), Path(setting("OUT", "build/grades"))
    if platform not in PLATFORMS:
        stop(f"return to whom? Say FOR= one of {', '.join(PLATFORMS)}, with the settings of 'make grade'")
    directory, roster, grades = (Path(setting(name)) if setting(name) else None for name in ("SUBMISSIONS", "CLASS", "GRADES"))
    if directory is None or not directory.is_dir():
        stop(f"SUBMISSIONS={directory or ''}: expected the folder that was marked")
    roster = as_last_time(out, "class", roster)
    folder = out / "return" / platform
    try:
        folder.mkdir(parents=True, exist_ok=True)
        stems = exercises.stems(exercises.read())
        class_list = class_of(directory, roster, stems)
        ledger = read_ledger(Path(setting("LEDGER", str(out / "ledger.csv"))), stems, class_list.keys, class_list.fits)
        everybody = results(class_list, out, ledger)
        written = [pages_for(platform, everybody, folder)]
        if grades:
            sheet, words = fill(grades, platform, everybody, setting("COLUMN"), setting("SCALE") not in ("", "0"))
            put(str(folder), grades.name, sheet.bytes())
            print("".join(f"{line}\n" for line in words), end="")
            written.append(grades.name)
        elif platform != "folder":
            print("Without GRADES=file, as the platform gives it, no marks are filled in.")
    except (SheetError, ValueError) as error:
        stop(f"nothing more is written: {error}")
    except OSError as error:
        stop(f"{error.filename}: {why(error)}")
    print(f"In {folder}/: {'; '.join(filter(None, written)) or 'nothing'}")


main()
