"""test_report_formats.py - nothing that a student wrote forges a result in JSON, XML, TAP or CSV, or acts on a
terminal.

Each is read back by readers that share nothing with its writer, and what they count is what the
records say.
"""
import csv
import io
import json
import random
import re
import xml.dom.minidom

from grade.report.comment import width
from grade.report.formats import grades_csv, grades_tap, junit_xml, results_json
from grade.report.points import clean, points
from grade.report.text import closing
from grade.visible import visible
from . import read_back
from .fixtures import Sentences
from .records import HOSTILE, function, hostile_class, hostile_record, ordinary_class, record, stem

HOSTILES, ORDINARY = hostile_class(), ordinary_class()
POINTS = 10  # of each hostile record: four stems that were not judged, six functions


def gradescope(one: dict) -> dict:
    return json.loads(results_json(one), parse_constant=lambda name: 1 / 0)


def compile_errors() -> dict:
    """A compiler message in which words are followed by colons."""
    words = ["03-screen.c:8:6: error: request for member", "  union", "    8 |     v.x = 1;", "error: a: b", "note :  c", ": d", "key:", "- e: f", "---", "...", "| : g", "'quoted': h", "{}", "~"]
    return record("a", [stem("03-screen", state="does not compile", most=1.0, words="\n".join(words))],
                  "does not compile")


def unread(status: str, **more) -> dict:
    """A submission of which something cannot be read; the reason quotes a student's names."""
    reason = '=1+1<b>.zip"\n: the archive is broken # SKIP'
    return record("a", [], status, words=reason, max=100.0, **more)


class ReportFormats(Sentences):
    def test_what_cannot_be_read(self):
        whole = unread("cannot be read", score=None)
        partly = {**unread("partly read"), "stems": ordinary_class()[0]["stems"]}
        for one in (whole, partly):
            status, reason = one["status"], visible(one["words"])
            told = gradescope(one)["tests"][0]
            self.check(f"{status}: Gradescope's first test has the reason",
                       (told["name"], told["status"], told["output"]) == (status, "failed", reason), told)
            error = xml.dom.minidom.parseString(junit_xml([one])).getElementsByTagName("error")[0]
            self.check(f"{status}: JUnit has an error with the reason",
                       (error.getAttribute("message"), error.getAttribute("type")) == (reason, status), error)
            ok, words = read_back.tap_points(grades_tap([one]).encode())[0]
            self.check(f"{status}: TAP has a point that is not ok", not ok and words.endswith(status), words)
            self.check(f"{status}: and its message is the reason", json.dumps(reason) in grades_tap([one]))
        self.check("what cannot be read is 0 for Gradescope, which shows no reason without a score",
                   gradescope(whole)["score"] == 0 and whole["score"] is None)
        self.check("what is read in part has the marks of the rest", len(points(clean(partly))) > 1
                   and gradescope(partly)["score"] == partly["score"])

    def test_gradescope(self):
        told = [gradescope(one) for one in HOSTILES]
        self.check("Gradescope gets one test per function, and one per stem without verdicts",
                   all(len(each["tests"]) == POINTS for each in told))
        self.check("no test is hidden, which would hide the student's total",
                   all("visibility" not in test for each in told for test in each["tests"])
                   and all(each["visibility"] == "visible" for each in told))
        self.check("what the submission printed stays hidden",
                   all(each["stdout_visibility"] == "hidden" for each in told))
        self.check("all that a student wrote is shown as text",
                   all(part["output_format"] == "text" for each in told for part in [each, *each["tests"]]))
        self.check("marks are the record's", all(
            (each["score"], sum(test["score"] for test in each["tests"]), sum(test["max_score"] for test in each["tests"]))
            == (8, 8, 80) for each in told))
        self.check("tests pass where there are marks",
                   all([test["status"] for test in each["tests"]].count("passed") == 2 for each in told))
        numbers = [test["number"] for test in told[0]["tests"]]
        self.check("tests are numbered by chapter and function",
                   numbers == ["1", "2", "3", "4", "5.1", "5.2", "5.3", "5.4", "5.5", "5.6"])
        self.check("a test is named by stem and function",
                   told[0]["tests"][5]["name"] == "05-quadratic: object_quadratic")
        self.check("the whole record lies in extra_data",
                   gradescope(ORDINARY[0])["extra_data"]["record"] == ORDINARY[0])
        self.check("same record, same bytes",
                   all(results_json(one) == results_json(hostile_record(text, place))
                       for place, (one, text) in enumerate(zip(HOSTILES, HOSTILE))))
        self.check("results.json is ASCII", all(results_json(one).isascii() for one in HOSTILES))
        self.check("no half of a surrogate and no NUL, which databases refuse",
                   not any(re.search(r"(?<!\\)(\\\\)*\\u(0000|dc[89a-f]|d800)", results_json(one))
                           for one, text in zip(HOSTILES, HOSTILE)
                           if "\0" in text or "\ud800" in text or "\udce9" in text))
        failed = gradescope(record("a", [], "grader failed", score=None))
        self.check("without a mark there is neither a score nor a test", {"score", "tests"}.isdisjoint(failed)
                   and failed["output"].startswith("grader failed: no score"), failed)
        self.assertRaises(ValueError, results_json, record("a", [], score=float("nan")))

    def test_junit(self):
        data = junit_xml(HOSTILES)
        root = xml.dom.minidom.parseString(data).documentElement
        suites, cases = root.getElementsByTagName("testsuite"), root.getElementsByTagName("testcase")
        self.check("JUnit has a suite per submission", len(suites) == len(HOSTILE))
        self.check("JUnit has a case per function and per stem without verdicts",
                   len(cases) == POINTS * len(HOSTILE))
        found = {name: len(root.getElementsByTagName(name)) for name in ("failure", "error", "skipped")}
        self.check("wrong and unanswered fail, crashes are errors, a missing file is skipped",
                   found == {"failure": 3 * len(HOSTILE), "error": 4 * len(HOSTILE), "skipped": len(HOSTILE)})
        self.check("JUnit's own sums agree",
                   [root.getAttribute(name) for name in ("tests", "failures", "errors", "skipped")]
                   == [str(n * len(HOSTILE)) for n in (10, 3, 4, 1)])
        names = [case.getAttribute("name") for case in cases]
        self.check("no name of a case comes twice", len(set(names)) == len(names))
        self.check("there are only JUnit's elements",
                   {element.tagName for element in root.getElementsByTagName("*")}
                   == {"testsuite", "properties", "property", "testcase", "failure", "error", "skipped"})
        self.check("there is nothing in the place where GitLab looks for attachments", b"<system-out" not in data)
        self.check("names come through",
                   {visible(text) for text in HOSTILE} == {suite.getAttribute("name") for suite in suites})
        self.check("an empty submission fails, it is not skipped",
                   b"<failure" in junit_xml([ORDINARY[3]]) and b"<skipped" not in junit_xml([ORDINARY[3]]))
        self.check("a submission without stems has its case",
                   junit_xml([record("a", [], "crashed")]).count(b"<testcase") == 1)

    def test_tap(self):
        data = grades_tap(HOSTILES).encode()
        found = read_back.tap_points(data)
        self.check("TAP has a point per function and per stem without verdicts",
                   len(found) == POINTS * len(HOSTILE))
        self.check("only right, waiting and skipped points are ok",
                   sum(ok for ok, _ in found) == 3 * len(HOSTILE))
        self.check("no directive but ours",
                   sum(bool(re.search(r"(?<!\\)(\\\\)*#", words)) for _, words in found) == len(HOSTILE))
        if read_back.has_tap_parser():
            *lines, end = read_back.perl_tap(data)
            told = [line for line in lines if not line.startswith("yaml ")]
            self.check("perl counts the same points", len(told) == POINTS * len(HOSTILE))
            self.check("perl reads what each failure says", len(lines) - len(told) == 7 * len(HOSTILE), lines[:3])
            words = compile_errors()
            read = read_back.perl_tap(grades_tap([words]).encode())
            said = [point["lines"] for point in points(clean(words))]
            self.check("perl reads a compiler's words as they are",
                       [line for line in read if line.startswith("yaml ")]
                       == ["yaml " + "|".join(["03-screen.c does not compile", *lines]) for lines in said], read)
            self.check("perl finds no error", end == f"errors 0 planned {POINTS * len(HOSTILE)} version 13")
            self.check("perl finds the same ones ok",
                       sum(line.startswith("ok ") for line in told) == 3 * len(HOSTILE))
            self.check("perl skips what we skip and nothing is TODO",
                       sum(line.startswith("ok skip ") for line in told) == len(HOSTILE)
                       and not any(line.startswith(("ok todo", "not ok todo", "bail", "unknown")) for line in told))
        else:
            self.skip("TAP as perl reads it: TAP::Parser is missing ('make setup FOR=contributor' installs it)")


# ---- the grade book, the terminal, and all of them ----------------------------------------------


# No C0 or C1 except line ends, no characters that break or reverse lines, and no invalid ones.
NO_CONTROLS = re.compile("[^\x00-\x09\x0b-\x1f\x7f-\x9f" "\u2028\u2029\u202a-\u202e\u2066-\u2069\ufeff\ufffe\uffff]*")



class ReportTables(Sentences):
    def test_csv(self):
        data = grades_csv(HOSTILES).encode()
        rows = read_back.strict_csv(data)
        self.check("the grade book has one row per submission", len(rows) == 1 + len(HOSTILE))
        self.check("its columns are submission, status, score, max, the stems and the reason",
                   rows[0] == ["submission", "status", "score", "max", "01-corners", "02-cameras", "03-screen",
                               "04-pixel-ray", "05-quadratic", "reason"])
        self.check("all rows are as wide", {len(row) for row in rows} == {10})
        self.check("marks are in their columns",
                   all(row[1:-1] == ["crashed", "8", "80", "0", "0", "0", "0", "8"] for row in rows[1:]))
        self.check("no cell is run by a spreadsheet",
                   not any(re.match(r"\s*[=+\-@\t\r＝＋－＠]", cell) for row in rows for cell in row))
        self.check("nor where semicolons part cells",
                   not any(re.search(r"(^|;)\s*[=+\-@]", re.sub(r'"([^"]|"")*"', "", line))
                           for line in data.decode("utf-8-sig").split("\r\n")))
        self.check("such a name is written after an apostrophe", "'=cmd|' /C calc'!A0" in {row[0] for row in rows})
        self.check("python's strict reader agrees",
                   list(csv.reader(io.StringIO(data.decode("utf-8-sig"), newline=""), strict=True)) == rows)
        lacking = grades_csv([record("a", [stem("01-corners", [function("upper_left")])]), record("b", [])])
        self.check("whoever lacks a stem has 0 there",
                   read_back.strict_csv(lacking.encode())[2] == ["b", "graded", "0", "0", "0", ""])

    def test_text(self):
        for name, them in (("hostile", HOSTILES), ("ordinary", ORDINARY), ("empty", []),
                           ("long", ordinary_class(300, 7) + HOSTILES)):
            told = closing(them)
            self.check(f"the closing table of the {name} class fits a terminal",
                       all(width(line) <= 79 for line in told.splitlines()))
            self.check(f"nothing in that of the {name} class drives the terminal", NO_CONTROLS.fullmatch(told))
        told = closing(ordinary_class(300, 7)).splitlines()
        self.check("a long class is shortened", len(told) < 80 and any("more; above are" in line for line in told))
        told = closing(ORDINARY)
        self.check("an ordinary class is shown whole", all(one["submission"][:8] in told for one in ORDINARY))
        # 1 to 8: by hand, the quartiles that include both ends are 2.75, 4.5, 6.25.
        eight = [record(f"g{n}", [stem("01-corners", [function("upper_left", most=8.0)])], score=float(n))
                 for n in range(1, 9)]
        self.check("median and quartiles are right",
                   "median 4.5 of 8, the middle half from 2.75 to 6.25" in closing(eight))
        self.check("each score is in its tenth",
                   "  90-100  # 1\n   80-89  # 1\n   70-79  # 1\n   60-69  # 1\n" in closing(eight))
        known = {"id": "Q1", "formula": "b = p.v", "why": "Multiply out.", "picture": "holes"}
        wrong = [function("object_quadratic", state="wrong", test="the_deck", mistake=known if n < 3 else None)
                 for n in range(5)]
        made = [record(f"g{n}", [stem("05-quadratic", [one])]) for n, one in enumerate(wrong)]
        self.check("the mistake made most comes first, with how many made it", "again next week\n"
                   "    3 of 5  05-quadratic  object_quadratic\n      b = p.v: multiply out.\n"
                   "    2 of 5  05-quadratic  object_quadratic\n      fails: the deck\n" in closing(made))

    def test_all(self):
        reports = {"grades.csv": grades_csv, "junit.xml": lambda them: junit_xml(them).decode(), "grades.tap": grades_tap,
                   "terminal": closing}
        mixed = HOSTILES + ORDINARY
        shuffled = random.Random(1).sample(mixed, len(mixed))
        unsafe = [{**one, "unsafe": True} for one in ORDINARY]
        for name, report in reports.items():
            self.check(f"{name} is the same in any order", report(mixed) == report(shuffled))
            self.check(f"{name} says when marks are unsafe",
                       "UNSAFE" in report(unsafe) and "UNSAFE" not in report(ORDINARY))
            self.check(f"{name} has no control characters",
                       NO_CONTROLS.fullmatch(report(mixed).removeprefix("\ufeff").replace("\r\n", "\n")))
            self.check(f"{name} of nobody can be written", report([]))
        self.check("results.json says when marks are unsafe",
                   all("UNSAFE" in json.loads(results_json(one))["output"] for one in unsafe))
        self.check("making visible twice is making visible once",
                   all(visible(visible(text)) == visible(text) for text in HOSTILE if len(text) < 9000))
        self.check("a record that was cleaned stays as it is", clean(clean(ORDINARY[8])) == clean(ORDINARY[8]))
