"""test_comment.py - a report says what 'make exercises' prints, and nothing hidden."""
import json
import os
import pathlib

from grade.report.ci import grades_tap, junit_xml
from grade.report.columns import fitted, width
from grade.report.comment import fields, function_lines, stem_lines, stem_says
from grade.report.gradescope import results_json
from grade.report.html import submission_page
from grade.visible import number, visible
from .make_records import function, record, stem
from .sentences import Sentences

README = pathlib.Path(__file__).resolve().parents[3] / "exercises/README.md"
CANARIES = ("8.12345", "CANARY")

MISTAKE = {
    "id": "C1",
    "formula": "d f + w r + h u",
    "picture": "everything at half its size",
    "why": "The whole width and height. f reaches the middle of the plane, and each edge is only "
    "half as far from there.",
}
UPPER_RIGHT = function(
    "upper_right",
    "Finding vectors from the eye",
    "Give an expression.",
    "wrong",
    mistake=MISTAKE,
    test="the_upper_right_corner_of_the_example",
    expected="(1, 1, 4)",
    yours="(2, 2, 4)",
    given=[
        [
            "camera",
            "eye~(2, 2, -4), right~(1, 0, 0), up~(0, 1, 0), forward~(0, 0, 1), d~4, w~2, h~2",
        ]
    ],
)


class Comment(Sentences):
    def test_visible(self):
        raw = (
            "a\0\x1b[2J\n\t\r\x7f\x85"
            + os.fsdecode(b"\xff")
            + "\ud800\u2028\u202e\ufeff\uffff\U000e0041 \u00e9\u5b57\\n"
        )
        self.check(
            "what acts is shown and does not act",
            visible(raw)
            == (
                r"a\x00\x1b[2J\n\t\r\x7f\x85\xff\ud800\u2028\u202e\ufeff\uffff\U000e0041 "
                + "\u00e9\u5b57\\n"
            ),
        )
        self.check(
            "lines stay where they are wanted",
            visible("a\r\nb\x07\n\tc", lines=True) == "a\nb\\x07\n        c",
        )
        self.check(
            "what is too long is cut, and says so", visible("x" * 10_001) == "x" * 10_000 + " ... (cut)"
        )
        self.check(
            "columns are counted as a terminal does",
            [width(text) for text in ("ab", "\u5b57", "e\u0301")] == [2, 2, 1],
        )
        self.check(
            "a name that is too long ends in two dots",
            fitted("abcdef", 5) == "abc.."
            and fitted("\u5b57" * 3, 5) == "\u5b57.. "
            and fitted("ab", 5) == "ab   ",
        )
        self.check(
            "marks are written as people write them",
            [number(x) for x in (74.0, 18.5, 1 / 3, 0.0, -0.0, 100)]
            == ["74", "18.5", "0.33", "0", "0", "100"],
        )

    def test_words(self):
        block = (
            README.read_text(encoding="utf-8").split("    01-corners  upper_right ")[1].split("\n\n")[0]
        )
        # The page has no formula of a mistake, because the students' archive has none.
        block = block.replace("looks like a known mistake:", "looks like d f + w r + h u:")
        # A figure is drawn where the student is, not where somebody grades.
        wanted = [line[4:] for line in block.split("\n")[1:] if not line.startswith("      see ")]
        self.check(
            "a comment is what the students' page shows of 'make exercises', but for the figure",
            function_lines("01-corners", UPPER_RIGHT) == wanted,
        )
        self.check(
            "of what is right there is nothing to say",
            function_lines("01-corners", function("a")) == [],
        )
        waiting = function("hit_sphere", state="waiting", waiting_for=["quadratic_roots"])
        self.check(
            "what waits says for what, and has its marks",
            function_lines("05-quadratic", waiting)
            == ["  right once quadratic_roots is; it has its marks"],
        )
        waiting["waiting_for"] += ["sphere_roots"]
        self.check(
            "and for several",
            fields("05-quadratic", waiting)
            == [("", "right once quadratic_roots and sphere_roots are; it has its marks")],
        )
        self.check(
            "a blank says what is asked",
            fields("01-corners", {**UPPER_RIGHT, "state": "unanswered"})
            == [("asked", "Give an expression."), ("try", "make hint EX=01")],
        )
        endless = {
            **UPPER_RIGHT,
            "state": "timed out",
            "how": "was still running after 1 s (an endless loop?)",
        }
        self.check(
            "an endless loop is not diagnosed, but looked for",
            function_lines("01-corners", endless)[-2:]
            == [
                "  it         was still running after 1 s (an endless loop?)",
                "  try        make debug EX=01",
            ],
        )
        self.check(
            "a second mistake is not kept secret",
            "(Something else is also not right yet.)"
            in " ".join(function_lines("01-corners", {**UPPER_RIGHT, "partly": True})),
        )
        law = {**UPPER_RIGHT, "mistake": None, "law": "it is not in the plane"}
        self.check(
            "without a known mistake the comment names the broken law",
            ("but", "it is not in the plane") in fields("01-corners", law),
        )
        self.check(
            "a long vector is not broken",
            "             right (1, 0, 0)"
            in function_lines(
                "01-corners",
                {**UPPER_RIGHT, "given": [["camera", "eye~(" + "2" * 45 + ", 2), right~(1, 0, 0)"]]},
            ),
        )

    def test_stems(self):
        twice = stem("02-cameras", state="twice", words="a/02-cameras.c\nb/02-cameras.c\n")
        self.check(
            "two files of one name are both named",
            stem_lines(twice)
            == [
                "there is more than one file called 02-cameras.c, and which is meant is not guessed:",
                "a/02-cameras.c",
                "b/02-cameras.c",
            ],
        )
        self.check(
            "a missing file is named",
            stem_lines(stem("02-cameras", state="missing")) == ["no 02-cameras.c was found"],
        )
        self.check("a judged stem has nothing to say", stem_says(stem("02-cameras")) == "")

    def test_hidden(self):
        # Though the record holds what it should not.
        hidden = {
            **UPPER_RIGHT,
            "hidden": True,
            "expected": "CANARY",
            "yours": "8.12345",
            "law": "8.12345",
            "given": [["camera", "CANARY"]],
        }
        bare = {**hidden, "mistake": None}
        one = record("a", [stem("01-corners", [hidden, {**bare, "name": "upper_left"}])])
        results = json.loads(results_json(one))
        del results["extra_data"]
        told = {
            "index.html": submission_page(one, "."),
            "results.json": json.dumps(results),
            "junit.xml": junit_xml([one]).decode(),
            "grades.tap": grades_tap([one]),
        }
        for name, text in told.items():
            self.check(f"{name} prints no hidden input", not any(canary in text for canary in CANARIES))
            self.check(
                f"{name} describes it",
                "inputs drawn at random for this run" in text
                and "the upper right corner of the example" in text,
            )
        self.check("a mistake is named all the same", fields("01-corners", hidden)[2][0] == "looks like")
