"""test_return.py - what goes back to the students: pages and grade files as each platform takes them, for 300 people; and
reading them back gives the same marks.
"""
import csv
import os
import subprocess
import sys
import zipfile
from pathlib import Path

from grade.people.matching import class_of
from grade.people.history import remember
from grade.people.sheets import Sheet
from grade.report import files
from grade.report.points import NOTHING
from . import platforms
from .fixtures import WithFolder, lay
from .records import function, record, stem

STEMS = ["01-corners"]
# FOR, the list and the download of the class, the file of grades, its columns of mark and comment
RETURNS = [
    ("moodle", platforms.own_list, platforms.moodle, platforms.moodle_worksheet, "Grade", "Feedback comments"),
    ("moodle", platforms.moodle_worksheet, platforms.moodle_loose, platforms.moodle_worksheet, "Grade", "Feedback comments"),
    ("canvas", platforms.canvas_gradebook, platforms.canvas, platforms.canvas_gradebook, "Week 2 (78)", None),
    ("gradescope", platforms.own_list, platforms.gradescope, platforms.gradescope_grades, "Week 1", None),
    ("blackboard", platforms.blackboard_column, platforms.blackboard, platforms.blackboard_column,
     "Week 1 [Total Pts: 10 Score] |1234", None),
]


class Returned(WithFolder):
    def setUp(self):
        super().setUp()
        self.out, self.room, self.list = self.work / "out", self.work / "class", self.work / "list.csv"

    def marked(self, them: list, download, roster) -> list:
        """A class with marks, though nobody has marked it: of the student n of the list 0.01 n."""
        self.room.mkdir()
        self.list.write_bytes(roster(them))
        lay(self.room, download(them))
        records = []
        for one in class_of(self.room, self.list, STEMS).found:
            place = next(at for at, student in enumerate(them) if one.person.key in (student.id, student.login, student.mail))
            score = place / 100 if one.parts else 0
            made = record(one.name, [stem("01-corners", [function("a", most=10.0)])] if one.parts else [], folder=one.folder,
                          score=score, max=10, status="graded" if one.parts else NOTHING,
                          person={field: getattr(one.person, field) for field in ("name", "id", "login", "mail") if getattr(one.person, field)})
            records.append(made)
        self.write(records)
        return records

    def write(self, records: list) -> None:
        """As if they had just been marked."""
        for one in records:
            if one["stems"]:
                files.write_submission(one, str(self.out / one["folder"]))
        remember(records, self.out)

    def command(self, platform, **settings) -> tuple:
        environment = {**os.environ, "PYTHONPATH": "tests", "FOR": platform, "SUBMISSIONS": str(self.room), "CLASS": str(self.list), "OUT": str(self.out)}
        environment.update({name: str(value) for name, value in settings.items()})
        return [sys.executable, "-B", "-m", "grade.people.hand_back"], environment

    def hand_back(self, platform, **settings) -> str:
        words, environment = self.command(platform, **settings)
        done = subprocess.run(words, env=environment, capture_output=True, text=True)
        return done.stdout + done.stderr

    def grades(self, raw: bytes) -> Path:
        path = self.work / "grades.csv"
        path.write_bytes(raw)
        return path

    def test_each_platform_gets_its_own_file_back_with_the_marks_in_it(self):
        for platform, roster, download, grades, column, comments in RETURNS:
            with self.subTest(platform):
                them = platforms.students()
                if (roster, download) == (platforms.own_list, platforms.moodle):
                    them[0].texts = them[1].texts = []  # of one name, which is all that is known of them
                marks = {one.mail: made["score"] for one, made in zip(them, self.marked(them, download, roster), strict=True)}
                mail_of = {word: one.mail for one in them for word in (one.mail, one.id)}
                given = grades(them + [platforms.Student("Not", "Ours", "99999", "other", 1)])
                said = self.hand_back(platform, GRADES=self.grades(given), COLUMN=column)
                back = Sheet(self.out / "return" / platform / "grades.csv")
                before = Sheet(self.work / "grades.csv")
                place, comment = back.column(column), back.column(comments) if comments else None
                found = {}
                for row, was in zip(back.rows, before.rows, strict=True):
                    cells, old = list(row.written), list(was.written)
                    identity = [mail_of[word] for word in row.cells() if word in mail_of]
                    if identity:
                        found[identity[0]] = float(back.cell(row, place))
                    cells[place], old[place] = "", ""
                    if comment is not None and identity:
                        self.assertIn(" of 10", back.cell(row, comment))
                        cells[comment], old[comment] = "", ""
                    self.assertEqual((cells if identity else row.written, row.end), (old if identity else was.written, was.end))
                self.assertEqual(found, marks)
                self.assertIn("Only in grades.csv, left as they are: 1, Not Ours", said)
                first = back.bytes()
                self.grades(first)
                self.hand_back(platform, GRADES=self.work / "grades.csv", COLUMN=column)
                self.assertEqual((self.out / "return" / platform / "grades.csv").read_bytes(), first)
            self.setUp()

    def test_pages_have_the_names_of_the_download(self):
        for platform, roster, download, name in (("moodle", platforms.own_list, platforms.moodle, "/feedback.html"),
                                                 ("moodle", platforms.own_list, platforms.moodle_loose, "feedback.html"),
                                                 ("canvas", platforms.canvas_gradebook, platforms.canvas, "feedback.html")):
            them = platforms.students(40)
            them[0].texts = them[1].texts = []
            self.marked(them, download, roster)
            said = self.hand_back(platform)
            with zipfile.ZipFile(self.out / "return" / platform / "feedback.zip") as archive:
                pages = archive.namelist()
            handed_in = [one for one in them if one.texts]
            self.assertEqual(len(pages), len(handed_in), said)
            given = {path.split("/")[0] if name[0] == "/" else path for path in download(them)}
            for page in pages:
                begins = page[:-len(name)] if name[0] == "/" else page.removesuffix(name)
                self.assertTrue(begins in given or any(path.startswith(begins) for path in given), page)
            self.setUp()

    def test_a_folder_has_a_page_for_each_and_says_whose(self):
        records = self.marked(platforms.students(12), platforms.own, platforms.own_list)
        self.hand_back("folder")
        with open(self.out / "return" / "folder" / "mail.csv", encoding="utf-8-sig", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["mail"] for row in rows], [one["person"]["mail"] for one in records if one["stems"]])
        for row in rows:
            self.assertIn(b"<h1>", (self.out / "return" / "folder" / row["page"]).read_bytes())

    def test_a_mark_that_cannot_be_changed_stays(self):
        them = platforms.students(12)
        self.marked(them, platforms.moodle, platforms.moodle_worksheet)
        given = platforms.moodle_worksheet(them).replace(b"10.00,Yes", b"10.00,No", 1)
        said = self.hand_back("moodle", GRADES=self.grades(given))
        back = Sheet(self.out / "return" / "moodle" / "grades.csv")
        self.assertEqual([bool(back.cell(row, back.column("Grade"))) for row in back.rows[1:]], [False] + [True] * 11)
        self.assertIn("cannot be changed: 1, Anna Abel", said)

    def test_whoever_is_excused_from_a_chapter_has_as_large_a_part_of_the_whole(self):
        them = platforms.students(12)
        records = self.marked(them, platforms.canvas, platforms.canvas_gradebook)
        records[2].update(score=3, max=6)
        self.write(records)
        self.hand_back("canvas", GRADES=self.grades(platforms.canvas_gradebook(them)), COLUMN="Week 1")
        back = Sheet(self.out / "return" / "canvas" / "grades.csv")
        self.assertEqual([back.cell(back.rows[at + 2], back.column("Week 1 (77)")) for at in (2, 3)], ["5", "0.03"])

    def test_a_page_has_the_name_of_the_last_upload(self):
        one = platforms.Student("Anna", "Abel", "1", "u1", 4000, texts=[b"first", b"second"])
        self.marked([one], platforms.canvas, platforms.canvas_gradebook)
        self.hand_back("canvas")
        with zipfile.ZipFile(self.out / "return" / "canvas" / "feedback.zip") as archive:
            self.assertEqual(archive.namelist(), ["abelanna_4000_29001_feedback.html"])

    def test_of_two_that_fit_one_line_the_second_is_said(self):
        lay(self.room, {"anna/01-corners.c": b"x", "u1/01-corners.c": b"x"})
        made = [record(one.name, [stem("01-corners", [function("a", most=10.0)])], folder=one.folder, score=at + 1)
                for at, one in enumerate(class_of(self.room, None, STEMS).found)]
        self.write(made)
        said = self.hand_back("gradescope", GRADES=self.grades(b"First Name,Last Name,SID,Email,Week 1\nAnna,,1,u1@x.org,\n"),
                              COLUMN="Week 1", CLASS="")
        self.assertIn("Not in grades.csv: 1, u1", said)
        self.assertIn(b"u1@x.org,1\n", (self.out / "return" / "gradescope" / "grades.csv").read_bytes())

    def test_hostile_names_stay_names(self):
        names = ["=1+1", "a\nb", "-rf", "@x", "<script>", "it's \"so\"", "Eve_1_assignsubmission_file_", "=x_2_assignsubmission_file_"]
        lay(self.room, {f"{name}/01-corners.c": b"x" for name in names})
        found = class_of(self.room, None, STEMS).found
        made = [record(one.name, [stem("01-corners", [function("a")])], folder=one.folder) for one in found]
        self.write(made)
        for platform in ("folder", "moodle"):
            words, environment = self.command(platform)
            done = subprocess.run(words, env={**environment, "CLASS": ""}, capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.out / "return" / "folder" / "mail.csv", encoding="utf-8-sig", newline="") as file:
            rows = list(csv.reader(file, strict=True))
        self.assertEqual(len(rows), 1 + len(names))
        self.assertFalse([cell for row in rows for cell in row if cell[:1] in tuple("=+-@")])
        self.assertTrue(all((self.out / "return" / "folder" / row[0].removeprefix("'")).exists() for row in rows[1:]))
        with zipfile.ZipFile(self.out / "return" / "moodle" / "feedback.zip") as archive:
            self.assertEqual(sorted(archive.namelist()), [f"{name}/feedback.html" for name in sorted(names[-2:])])

    def test_what_cannot_be_returned_is_said(self):
        them = platforms.students(12)
        self.marked(them, platforms.canvas, platforms.canvas_gradebook)
        grades = self.grades(platforms.canvas_gradebook(them))
        for platform, settings, words in (
                ("nowhere", {}, "return to whom? Say FOR= one of moodle, canvas"),
                ("canvas", {"GRADES": grades}, "2 columns may be for these marks, expected COLUMN="),
                ("canvas", {"GRADES": grades, "COLUMN": "Section"}, "0 columns may be for these marks, expected COLUMN="),
                ("canvas", {"GRADES": self.work / "none.csv"}, "none.csv: cannot be read"),
                ("canvas", {"OUT": self.work}, "holds no marks: run 'make grade' first"),
                ("canvas", {"SUBMISSIONS": self.work / "none"}, "expected the folder that was marked")):
            self.assertIn(words, self.hand_back(platform, **settings))
        (self.out / "ledger.csv").write_text(f"who,chapter,what,value\n{them[0].id},,mark,3\n")
        self.assertIn("run 'make grade' first", self.hand_back("canvas"))
        (self.out / "ledger.csv").unlink()
        grades.write_bytes(grades.read_bytes().replace(b",10,10,", b",10,25,"))
        self.assertIn("its marks are of 25, and these of 10: change the points", self.hand_back("canvas", GRADES=grades, COLUMN="Week 2"))
        self.hand_back("canvas", GRADES=grades, COLUMN="Week 2", SCALE=1)
        back = Sheet(self.out / "return" / "canvas" / "grades.csv")
        self.assertEqual(back.cell(back.rows[4], back.column("Week 2 (78)")), "0.05" if them[2].texts else "0")
