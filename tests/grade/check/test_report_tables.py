"""test_report_tables.py - the grade book, the terminal, and what holds of all reports."""
import csv
import io
import json
import random
import re

from grade.report.ci import grades_tap, junit_xml
from grade.report.columns import width
from grade.report.gradebook import grades_csv
from grade.report.gradescope import results_json
from grade.report.points import clean
from grade.report.text import closing
from grade.visible import visible
from . import read_back
from .hostile_records import HOSTILE, hostile_class
from .make_records import function, record, stem
from .sample_records import ordinary_class
from .sentences import Sentences

HOSTILES, ORDINARY = hostile_class(), ordinary_class()
# No C0 or C1 except line ends, no characters that break or reverse lines, and no invalid ones.
NO_CONTROLS = re.compile(
    "[^\x00-\x09\x0b-\x1f\x7f-\x9f" "\u2028\u2029\u202a-\u202e\u2066-\u2069\ufeff\ufffe\uffff]*"
)


# ---- the terminal, and all of them --------------------------------------------------------------


class ReportTables(Sentences):
    def test_csv(self):
        data = grades_csv(HOSTILES).encode()
        rows = read_back.strict_csv(data)
        self.check("the grade book has one row per submission", len(rows) == 1 + len(HOSTILE))
        self.check(
            "its columns are submission, status, score, max and the stems",
            rows[0]
            == [
                "submission",
                "status",
                "score",
                "max",
                "01-corners",
                "02-cameras",
                "03-screen",
                "04-pixel-ray",
                "05-quadratic",
            ],
        )
        self.check("all rows are as wide", {len(row) for row in rows} == {9})
        self.check(
            "marks are in their columns",
            all(row[1:] == ["crashed", "8", "80", "0", "0", "0", "0", "8"] for row in rows[1:]),
        )
        self.check(
            "no cell is run by a spreadsheet",
            not any(re.match(r"\s*[=+\-@\t\r＝＋－＠]", cell) for row in rows for cell in row),
        )
        self.check(
            "nor where semicolons part cells",
            not any(
                re.search(r"(^|;)\s*[=+\-@]", re.sub(r'"([^"]|"")*"', "", line))
                for line in data.decode("utf-8-sig").split("\r\n")
            ),
        )
        self.check(
            "such a name is written after an apostrophe",
            "'=cmd|' /C calc'!A0" in {row[0] for row in rows},
        )
        self.check(
            "python's strict reader agrees",
            list(csv.reader(io.StringIO(data.decode("utf-8-sig"), newline=""), strict=True)) == rows,
        )
        self.check(
            "whoever lacks a stem has 0 there",
            read_back.strict_csv(
                grades_csv(
                    [record("a", [stem("01-corners", [function("upper_left")])]), record("b", [])]
                ).encode()
            )[2]
            == ["b", "graded", "0", "0", "0"],
        )

    def test_text(self):
        for name, them in (
            ("hostile", HOSTILES),
            ("ordinary", ORDINARY),
            ("empty", []),
            ("long", ordinary_class(300, 7) + HOSTILES),
        ):
            told = closing(them)
            self.check(
                f"the closing table of the {name} class fits a terminal",
                all(width(line) <= 79 for line in told.splitlines()),
            )
            self.check(
                f"nothing in that of the {name} class drives the terminal", NO_CONTROLS.fullmatch(told)
            )
        told = closing(ordinary_class(300, 7)).splitlines()
        self.check(
            "a long class is shortened",
            len(told) < 80 and any("more; above are" in line for line in told),
        )
        told = closing(ORDINARY)
        self.check(
            "an ordinary class is shown whole", all(one["submission"][:8] in told for one in ORDINARY)
        )
        # 1 to 8: by hand, the quartiles that include both ends are 2.75, 4.5, 6.25.
        eight = [
            record(f"g{n}", [stem("01-corners", [function("upper_left", most=8.0)])], score=float(n))
            for n in range(1, 9)
        ]
        self.check(
            "median and quartiles are right",
            "median 4.5 of 8, the middle half from 2.75 to 6.25" in closing(eight),
        )
        self.check(
            "each score is in its tenth",
            "  90-100  # 1\n   80-89  # 1\n   70-79  # 1\n   60-69  # 1\n" in closing(eight),
        )
        known = {"id": "Q1", "formula": "b = p.v", "why": "Multiply out.", "picture": "holes"}
        made = [
            record(
                f"g{n}",
                [
                    stem(
                        "05-quadratic",
                        [
                            function(
                                "object_quadratic",
                                state="wrong",
                                test="the_deck",
                                mistake=known if n < 3 else None,
                            )
                        ],
                    )
                ],
            )
            for n in range(5)
        ]
        self.check(
            "the mistake made most comes first, with how many made it",
            "again next week\n"
            "    3 of 5  05-quadratic  object_quadratic\n      b = p.v: multiply out.\n"
            "    2 of 5  05-quadratic  object_quadratic\n      fails: the deck\n" in closing(made),
        )

    def test_all(self):
        reports = {
            "grades.csv": grades_csv,
            "junit.xml": lambda them: junit_xml(them).decode(),
            "grades.tap": grades_tap,
            "terminal": closing,
        }
        mixed = HOSTILES + ORDINARY
        shuffled = random.Random(1).sample(mixed, len(mixed))
        unsafe = [{**one, "unsafe": True} for one in ORDINARY]
        for name, report in reports.items():
            self.check(f"{name} is the same in any order", report(mixed) == report(shuffled))
            self.check(
                f"{name} says when marks are unsafe",
                "UNSAFE" in report(unsafe) and "UNSAFE" not in report(ORDINARY),
            )
            self.check(
                f"{name} has no control characters",
                NO_CONTROLS.fullmatch(report(mixed).removeprefix("\ufeff").replace("\r\n", "\n")),
            )
            self.check(f"{name} of nobody can be written", report([]))
        self.check(
            "results.json says when marks are unsafe",
            all("UNSAFE" in json.loads(results_json(one))["output"] for one in unsafe),
        )
        self.check(
            "making visible twice is making visible once",
            all(visible(visible(text)) == visible(text) for text in HOSTILE if len(text) < 9000),
        )
        self.check(
            "a record that was cleaned stays as it is", clean(clean(ORDINARY[8])) == clean(ORDINARY[8])
        )
