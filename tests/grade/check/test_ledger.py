"""test_ledger.py - what an instructor decides, what it does to marks, and that a wrong line changes nothing."""
import copy
import os
import random
import signal
import subprocess
import sys
import time
from fractions import Fraction

from grade.people.history import lines_of, members, remember
from grade.people.ledger import add_decision, check_marks, decide, read_ledger
from grade.people.sheets import SheetError
from .fixtures import STEMS, WithFolder
from .records import function, record, stem

HEADING = "who,chapter,what,value,comment,by,when\n"
# Adds so many comments: LEDGER WORD NUMBER.
ADDING = """
import sys; sys.path.insert(0, 'tests')
from pathlib import Path
from grade.people.ledger import add_decision
for at in range(int(sys.argv[3])):
    add_decision(Path(sys.argv[1]), ['anna', '', 'comment', '', f'{sys.argv[2]} {at}', '', ''], [], lambda who: ['1'], str)
    print(at, flush=True)
"""
PEOPLE = {"anna": ["1"], "ben": ["2"], "kim": ["3", "4"]}


def fits(who: str) -> str:
    return f"fits {len(PEOPLE.get(who, []))} people"


def two_chapters() -> dict:
    """6 of 10 and 8 of 20."""
    return record("anna", [stem("01-corners", [function("a", most=6.0), function("b", state="wrong", most=4.0)]),
                           stem("05-quadratic", [function("c", most=8.0), function("d", state="wrong", most=12.0)])])


class Ledgers(WithFolder):
    def setUp(self):
        super().setUp()
        self.path = self.work / "ledger.csv"

    def read(self, lines: str):
        self.path.write_text(HEADING + lines)
        return read_ledger(self.path, STEMS, lambda who: PEOPLE.get(who, []), fits)

    def after(self, lines: str, percent_late: int = 0, **changes) -> dict:
        found = {**two_chapters(), **changes}
        decide(found, self.read(lines).of("1"), {"01-corners": Fraction(10), "05-quadratic": Fraction(20)},
               lambda marks: Fraction(round(marks * percent_late), 100))
        if found["score"] is not None:
            self.assertEqual(sum(Fraction(str(found[part] or 0)) for part in ("computed", "penalty", "adjusted")),
                             Fraction(str(found["score"])))
        return found

    def test_a_mark_beyond_the_points_is_a_slip(self):
        most = {"01-corners": Fraction(10), "05-quadratic": Fraction(20)}
        for lines, wrong in (("anna,01,mark,10,,,\n", ""), ("anna,,mark,30,,,\n", ""), ("anna,01,credit,99,,,\n", ""),
                             ("anna,01,mark,10.5,,,\n", ":2: mark 10.5, expected at most 10, the points of 01-corners"),
                             ("anna,,credit,1,,,\nben,,mark,31,,,\n", ":3: mark 31, expected at most 30, the points of all chapters")):
            with self.subTest(lines):
                try:
                    check_marks(self.path, self.read(lines), most)
                    said = ""
                except SheetError as error:
                    said = str(error)
                self.assertTrue(said.startswith(f"{self.path}{wrong}") if wrong else said == "", said)

    def test_decisions_change_marks(self):
        for lines, final, most, words in (
                ("", 14, 30, []),
                ("ben,,mark,1,,,\n", 14, 30, []),
                ('anna,,points,"2,5",,,\n', 16.5, 30, ["points +2.5"]),
                ("anna,,mark,25.5,oral exam,MK,\n", 25.5, 30, ["mark 25.5: oral exam"]),
                ("anna,1,mark,10,,,\n", 18, 30, ["01-corners: mark 10"]),
                ("anna,01-corners,points,3,,,\n", 17, 30, ["01-corners: points +3"]),
                ("anna,01,points,30,,,\n", 18, 30, ["01-corners: points +30"]),
                ("anna,01,points,-7,,,\n", 8, 30, ["01-corners: points -7"]),
                ("anna,,points,-70,,,\n", 0, 30, ["points -70"]),
                ("anna,,points,'-3,,,\n", 11, 30, ["points -3"]),   # as a spreadsheet keeps it
                ("anna,,credit,1,quiz,,\nanna,,credit,2,essay,,\n", 17, 30, ["credit +1: quiz", "credit +2: essay"]),
                ("anna,1,credit,40,,,\nanna,,points,5,,,\n", 54, 30, ["01-corners: credit +40", "points +5"]),
                ("anna,,credit,20,,,\n", 34, 30, ["credit +20"]),
                ("anna,01,excused,,moved,,\n", 8, 20, ["01-corners: excused: moved"]),
                ("anna,,excused,,ill,,\n", None, 30, ["excused: ill"]),
                ("anna,,comment,,Well done.,,\n", 14, 30, ["Well done."]),
                ("anna,,comment,,'=1+1,,\n", 14, 30, ["=1+1"]),
                ("anna,1,points,1,,,\nanna,5,credit,2,,,\nanna,,points,1,,,\n", 18, 30,
                 ["01-corners: points +1", "05-quadratic: credit +2", "points +1"])):
            with self.subTest(lines):
                found = self.after(lines)
                self.assertEqual((found["score"], found["max"], found["decided"]), (final, most, words))

    def test_late_work_loses_its_part_of_what_was_decided_on_a_chapter_and_not_of_the_total(self):
        for lines, sums in (("", (14, -1.4, 0, 12.6)), ("anna,1,points,4,,,\n", (14, -1.4, 3.6, 16.2)),
                            ("anna,,points,4,,,\n", (14, -1.4, 4, 16.6)), ("anna,,mark,9,,,\n", (14, -1.4, -3.6, 9))):
            found = self.after(lines, 10)
            self.assertEqual(tuple(found[part] for part in ("computed", "penalty", "adjusted", "score")), sums)

    def test_the_columns_add_up_whatever_is_decided(self):
        chance = random.Random(3)
        kinds = ["mark", "points", "credit", "excused", "extra days", "comment"]
        tried = 0
        for _ in range(600):
            lines = ""
            for _ in range(chance.randrange(4)):
                what = chance.choice(kinds)
                value = "" if what in ("excused", "comment") else str(Fraction(chance.randrange(4000), 100).__float__())
                chapter = "" if what == "extra days" else chance.choice(["", "1", "5"])
                lines += f"anna,{chapter},{what},{value},word,,\n"
            try:
                self.after(lines, chance.choice([0, 10, 33, 100]), **chance.choice([{}, {"score": None, "stems": []}]))
                tried += 1
            except SheetError as error:
                self.assertIn("contradicts", str(error))
        self.assertGreater(tried, 200)

    def test_without_a_score_only_a_mark_gives_one(self):
        nothing = {"score": None, "stems": [], "status": "cannot be read"}
        for lines, final in (("", None), ("anna,,points,3,,,\n", None), ("anna,,mark,9,,,\n", 9), ("anna,1,mark,4,,,\n", 4)):
            found = self.after(lines, **copy.deepcopy(nothing))
            self.assertEqual((found["computed"], found["score"]), (None, final))

    def test_a_wrong_line_is_an_error_with_its_number(self):
        for lines, words in (("ben,,mark,1,,,\nzoe,,mark,1,,,\n", "3: zoe fits 0 people"),
                             ("kim,,mark,1,,,\n", "2: kim fits 2 people"),
                             (",,mark,1,,,\n", "2: nobody is named"),
                             ("anna,9,mark,1,,,\n", "2: no chapter is called 9, expected 01-corners, 05-quadratic"),
                             ("anna,,marks,1,,,\n", "2: marks is not decided here, expected extra days, excused"),
                             ("anna,,mark,,,,\n", "2: mark without a value, expected a number from 0"),
                             ("anna,,mark,-1,,,\n", "2: mark -1, expected a number from 0"),
                             ("anna,,points,1.234,,,\n", "2: points 1.234, expected a number"),
                             ("anna,,excused,1,,,\n", "2: excused has the value 1, expected none"),
                             ("anna,,comment,,,,\n", "2: a comment without words"),
                             ("anna,1,extra days,2,,,\n", "2: extra days for 01-corners alone"),
                             ("anna,,mark,1,,,\nanna,,mark,2,,,\n", "3: mark contradicts mark in line 2"),
                             ("anna,1,points,1,,,\nanna,,mark,2,,,\n", "3: mark contradicts points in line 2"),
                             ("anna,1,excused,,,,\nanna,1,points,2,,,\n", "3: points contradicts excused in line 2"),
                             ("anna,,excused,,,,\nanna,,credit,2,,,\n", "3: credit contradicts excused in line 2"),
                             ("anna,,extra days,1,,,\nanna,,extra days,2,,,\n", "3: extra days contradicts extra days in line 2"),
                             ('anna,,comment,,"a,,\n', "2: a quotation mark that does not end")):
            with self.subTest(lines):
                self.assertRaisesRegex(SheetError, f"ledger.csv:{words}", self.read, lines)

    def test_what_is_written_by_a_spreadsheet_is_read(self):
        for raw in ("\ufeffwho;chapter;what;value;comment;by;when\r\nanna;;mark;7;;;\r\n".encode(),
                    "what\tvalue\twho\tchapter\nmark\t7\tanna\t\n".encode("utf-16")):
            self.path.write_bytes(raw)
            found = read_ledger(self.path, STEMS, lambda who: PEOPLE.get(who, []), fits)
            self.assertEqual([one.value for one in found.of("1").all], [7])

    def test_a_line_that_would_not_hold_leaves_the_ledger_as_it_was(self):
        def add(*cells):
            return add_decision(self.path, list(cells), STEMS, lambda who: PEOPLE.get(who, []), fits)
        self.assertEqual(add("anna", "1", "points", "-3", "=cmd()", "MK", "2025-11-14"), 2)
        before = self.path.read_bytes()
        self.assertEqual(before.decode(), HEADING + "anna,1,points,-3,'=cmd(),MK,2025-11-14\n")
        self.assertRaisesRegex(SheetError, "ledger.csv:3: mark contradicts points in line 2", add, "anna", "1", "mark", "3", "", "", "")
        self.assertEqual(self.path.read_bytes(), before)
        self.assertEqual(add("ben", "", "comment", "", 'two\nlines, "quoted"', "", ""), 3)

    def test_two_may_write_at_once(self):
        writing = [subprocess.Popen([sys.executable, "-c", ADDING, self.path, str(at), "40"], stdout=subprocess.DEVNULL)
                   for at in range(3)]
        self.assertEqual([one.wait() for one in writing], [0, 0, 0])
        self.assertEqual(len(read_ledger(self.path, STEMS, lambda who: ["1"], str).of("1").all), 120)

    def test_killed_while_it_is_written_no_line_is_lost(self):
        """Twenty kills; each line that was acknowledged is there, and nothing else."""
        chance, done = random.Random(5), []
        for again in range(20):
            adding = subprocess.Popen([sys.executable, "-c", ADDING, self.path, str(again), "1000000"], stdout=subprocess.PIPE, text=True)
            adding.stdout.readline()
            time.sleep(chance.random() / 50)
            adding.send_signal(signal.SIGKILL)
            rest = adding.communicate()[0].split()
            done.append(1 + len(rest))
            found = [one.comment for one in read_ledger(self.path, STEMS, lambda who: ["1"], str).of("1").all]
            for run, least in enumerate(done):
                lines = [comment for comment in found if comment.startswith(f"{run} ")]
                self.assertEqual(lines, [f"{run} {at}" for at in range(len(lines))])
                self.assertIn(len(lines), (least, least + 1))
        self.assertEqual([name for name in os.listdir(self.work) if name.endswith(".csv")], ["ledger.csv"])


class Histories(WithFolder):
    def test_each_change_is_kept_with_its_reason(self):
        first = {**two_chapters(), "key": "k", "files": "f"}
        remember([first], self.work)
        self.assertEqual(list(members(self.work)), ["anna"])
        remember([first], self.work)
        for changes in ({"score": 9, "files": "g"}, {"score": 10, "decided": ["points +1: asked"]}, {"score": 11, "decided": []},
                        {"score": 12, "key": "l"}, {"score": 13, "computed": 3}):
            first = {**first, **changes}
            remember([first], self.work)
        self.assertEqual([line[1:] for line in lines_of(self.work)],
                         [["anna", "", "14", "30", "marked"], ["anna", "14", "9", "30", "handed in again"],
                          ["anna", "9", "10", "30", "points +1: asked"], ["anna", "10", "11", "30", "a decision was taken back"],
                          ["anna", "11", "12", "30", "the tests, the seed or the tools have changed"],
                          ["anna", "12", "13", "30", "judged again, or the policy has changed"]])
