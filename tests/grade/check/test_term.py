"""test_term.py - the weeks of a term beside each other: one person is one row, and nothing is counted twice or lost."""
import csv
import io
import re

from grade.people.history import remember
from grade.people.term import in_order, term_csv, term_page, weeks_of, weights_of
from grade.people.sheets import SheetError
from grade.report import files
from grade.visible import spelled
from .fixtures import Page, WithFolder
from .records import HOSTILE, MISTAKE, function, record, stem


class Term(WithFolder):
    def week(self, name: str, *records: dict) -> None:
        out = self.work / name
        out.mkdir()
        for one in records:
            if one["status"] != "nothing handed in":
                files.write_submission(one, str(out / one["folder"]))
        remember(list(records), out)

    def one(self, name: str, marks: float, number: str = "", of: float = 10.0, mistake=None, **more) -> dict:
        wrong = function("upper_left", state="wrong", most=of - marks, mistake=mistake)
        return record(name, [stem("01-corners", [function("upper_right", most=marks), wrong])],
                      person={"name": name, "id": number} if number else {}, **more)

    def rows(self) -> list:
        weeks = weeks_of(self.work)
        return list(csv.reader(io.StringIO(term_csv(weeks, weights_of(self.work, weeks)).lstrip("\ufeff"), newline="")))

    def percents(self, weights: str) -> list:
        (self.work / "weights.csv").write_text(weights, encoding="utf-8")
        return [row[-2] for row in self.rows()[1:]]

    def test_weeks_are_in_the_order_that_people_count_in(self):
        self.assertEqual(sorted(["week-10", "week-9", "extra", "week-1"], key=in_order), ["extra", "week-1", "week-9", "week-10"])

    def test_somebody_who_is_renamed_is_one_person(self):
        self.week("week-1", self.one("Kim Li", 6, "7"), self.one("Anna", 4, "8"))
        self.week("week-2", self.one("Kim Doe", 3, "7"), self.one("Kim Li", 9, "9"))
        self.assertEqual(self.rows(), [["name", "id", "week-1", "week-2", "sum", "of", "percent", "open"],
                                       ["Anna", "8", "4", "", "4", "10", "40", "0"],
                                       ["Kim Doe", "7", "6", "3", "9", "20", "45", "0"], ["Kim Li", "9", "", "9", "9", "10", "90", "0"]])

    def test_nothing_handed_in_is_0_and_no_score_is_no_part_of_the_sum(self):
        self.week("a", self.one("Anna", 6, "1"), record("Ben", [], "nothing handed in", folder="ben", max=10, person={"id": "2"}))
        self.week("b", {**self.one("Anna", 6, "1"), "status": "cannot be read", "score": None}, self.one("Ben", 5, "2"))
        self.assertEqual(self.rows()[1:], [["Anna", "1", "6", "", "6", "10", "60", "1"], ["Ben", "2", "0", "5", "5", "20", "25", "0"]])

    def test_a_week_counts_what_weights_csv_says(self):
        self.week("a", self.one("Anna", 6, "1"), self.one("Ben", 10, "2"))
        self.week("b", self.one("Anna", 9, "1"), {**self.one("Ben", 5, "2"), "status": "cannot be read", "score": None})
        self.week("exam", self.one("Anna", 20, "1", of=40.0), self.one("Ben", 40, "2", of=40.0))
        for weights, percents in (("week,weight\n", ["66.67", "100"]), ("week,weight\nexam,3\n", ["60", "100"]),
                                  ("week,weight\nexam,3\nb,0\n", ["52.5", "100"]), ("week,weight\nbest,2\n", ["75", "100"]),
                                  ("week,weight\na,0\nb,0\nexam,0\n", ["", ""])):
            self.assertEqual(self.percents(weights), percents, weights)
        (self.work / "weights.csv").unlink()
        self.assertEqual([row[-2] for row in self.rows()[1:]], ["58.33", "100"])    # 35 of 60, 50 of 50
        for weights, words in (("week;w\n", ":1: .*week,weight"), ("week,weight\na,1\nc,1\n", ":3: c is no week.*a, b, exam"),
                               ("week,weight\na,1\na,1\n", ":3: a is given twice"), ("week,weight\na,-1\n", ":2: -1, expected a number")):
            with self.assertRaisesRegex(SheetError, words):
                self.percents(weights)

    def test_two_of_one_name_are_told_apart(self):
        one = self.one("Jane Doe", 6, "1")
        self.week("a", {**one, "submission": "Jane Doe (1)", "folder": "j1"},
                  {**self.one("Jane Doe", 3, "2"), "submission": "Jane Doe (2)", "folder": "j2"})
        self.assertEqual([row[0] for row in self.rows()[1:]], ["Jane Doe (1)", "Jane Doe (2)"])
        self.assertIn("Jane Doe (2)", term_page(weeks_of(self.work)))

    def test_a_mistake_is_counted_in_each_week_that_asked_for_its_chapter(self):
        self.week("a", *(self.one(f"s{at}", 6, str(at), mistake=MISTAKE if at < 3 else None) for at in range(5)))
        self.week("b", self.one("s1", 6, "1", mistake=MISTAKE), self.one("s2", 6, "2"))
        self.week("c", record("s1", [stem("05-quadratic", [function("hit_sphere")])], person={"id": "1"}))
        told = re.sub(r"\s+", " ", " ".join(Page(term_page(weeks_of(self.work))).words))
        self.assertIn(f"01-corners upper_left {MISTAKE['formula']}", told)
        self.assertRegex(told, r"there\. 3 of 5 1 of 2 01-corners")
        self.assertIn("05-quadratic hit_sphere 1 of 1", told)

    def test_names_that_act_are_only_names(self):
        self.week("a", *({**self.one("x", 6), "submission": spelled(text), "folder": f"h{at}"} for at, text in enumerate(HOSTILE)))
        page = term_page(weeks_of(self.work))
        self.assertNotIn("<script", page)
        self.assertNotIn("\x1b", page)
        for row in self.rows()[1:]:
            self.assertNotIn(row[0].lstrip(" ")[:1], set("=+-@"))
