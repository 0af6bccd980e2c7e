"""test_report_formats.py - nothing that a student wrote forges a result in JSON, XML or TAP.

Each is read back by readers that share nothing with its writer, and what they count is what the
records say.
"""
import json
import re
import shutil
import xml.dom.minidom

from grade.report.ci import grades_tap, junit_xml
from grade.report.gradescope import results_json
from grade.report.points import clean, points
from grade.visible import visible
from . import read_back
from .hostile_records import HOSTILE, hostile_class, hostile_record
from .make_records import record, stem
from .sample_records import ordinary_class
from .sentences import Sentences

HOSTILES, ORDINARY = hostile_class(), ordinary_class()
POINTS = 10  # of each hostile record: four stems that were not judged, six functions


def says(text: str) -> str:
    """The text that a reader should find of a hostile string."""
    return visible(text)


# ---- JSON ---------------------------------------------------------------------------------------


def gradescope(one: dict) -> dict:
    return json.loads(results_json(one), parse_constant=lambda name: 1 / 0)


# ---- XML ----------------------------------------------------------------------------------------


# ---- TAP ----------------------------------------------------------------------------------------


def compile_errors() -> dict:
    """A compiler message in which words are followed by colons."""
    words = ["03-screen.c:8:6: error: request for member", "  union", "    8 |     v.x = 1;", "error: a: b",
             "note :  c",
             ": d", "key:", "- e: f", "---", "...", "| : g", "'quoted': h", "{}", "~"]
    return record("a", [stem("03-screen", state="does not compile", most=1.0, words="\n".join(words))],
                  "does not compile")


class ReportFormats(Sentences):
    def test_gradescope(self):
        told = [gradescope(one) for one in HOSTILES]
        self.check(
            "Gradescope gets one test per function, and one per stem without verdicts",
            all(len(each["tests"]) == POINTS for each in told),
        )
        self.check(
            "no test is hidden, which would hide the student's total",
            all("visibility" not in test for each in told for test in each["tests"])
            and all(each["visibility"] == "visible" for each in told),
        )
        self.check(
            "what the submission printed stays hidden",
            all(each["stdout_visibility"] == "hidden" for each in told),
        )
        self.check(
            "all that a student wrote is shown as text",
            all(part["output_format"] == "text" for each in told for part in [each, *each["tests"]]),
        )
        self.check(
            "marks are the record's",
            all(
                each["score"] == 8
                and sum(test["score"] for test in each["tests"]) == 8
                and sum(test["max_score"] for test in each["tests"]) == 80
                for each in told
            ),
        )
        self.check(
            "tests pass where there are marks",
            all([test["status"] for test in each["tests"]].count("passed") == 2 for each in told),
        )
        numbers = [test["number"] for test in told[0]["tests"]]
        self.check(
            "tests are numbered by chapter and function",
            numbers == ["1", "2", "3", "4", "5.1", "5.2", "5.3", "5.4", "5.5", "5.6"],
        )
        self.check(
            "a test is named by stem and function",
            told[0]["tests"][5]["name"] == "05-quadratic: object_quadratic",
        )
        self.check(
            "the whole record lies in extra_data",
            gradescope(ORDINARY[0])["extra_data"]["record"] == ORDINARY[0],
        )
        self.check(
            "same record, same bytes",
            all(
                results_json(one) == results_json(hostile_record(text, place))
                for place, (one, text) in enumerate(zip(HOSTILES, HOSTILE))
            ),
        )
        self.check("results.json is ASCII", all(results_json(one).isascii() for one in HOSTILES))
        self.check(
            "no half of a surrogate and no NUL, which databases refuse",
            not any(
                re.search(
                    r"(?<!\\)(\\\\)*\\u(0000|dc[89a-f]|d800)",
                    results_json(HOSTILES[HOSTILE.index(text)]),
                )
                for text in HOSTILE
                if "\0" in text or "\ud800" in text or "\udce9" in text
            ),
        )
        try:
            results_json(record("a", [], score=float("nan")))
            self.check("a mark that is not a number is refused", False)
        except ValueError:
            self.check("a mark that is not a number is refused", True)
        if read_back.has_perl("JSON::PP"):
            self.check(
                "perl reads the same JSON as python",
                read_back.perl_json(f"[{','.join(results_json(one) for one in HOSTILES)}]".encode())
                == told,
            )
        else:
            self.skip("JSON as perl reads it: JSON::PP is missing ('make setup FOR=contributor' installs it)")

    def test_junit(self):
        data = junit_xml(HOSTILES)
        root = xml.dom.minidom.parseString(data).documentElement
        suites, cases = root.getElementsByTagName("testsuite"), root.getElementsByTagName("testcase")
        self.check("JUnit has a suite per submission", len(suites) == len(HOSTILE))
        self.check(
            "JUnit has a case per function and per stem without verdicts",
            len(cases) == POINTS * len(HOSTILE),
        )
        found = {name: len(root.getElementsByTagName(name)) for name in ("failure", "error", "skipped")}
        self.check(
            "wrong and unanswered fail, crashes are errors, a missing file is skipped",
            found == {"failure": 3 * len(HOSTILE), "error": 4 * len(HOSTILE), "skipped": len(HOSTILE)},
        )
        self.check(
            "JUnit's own sums agree",
            [root.getAttribute(name) for name in ("tests", "failures", "errors", "skipped")]
            == [str(n * len(HOSTILE)) for n in (10, 3, 4, 1)],
        )
        names = [case.getAttribute("name") for case in cases]
        self.check("no name of a case comes twice", len(set(names)) == len(names))
        self.check(
            "there are only JUnit's elements",
            {element.tagName for element in root.getElementsByTagName("*")}
            == {"testsuite", "properties", "property", "testcase", "failure", "error", "skipped"},
        )
        self.check("there is nothing in the place where GitLab looks for attachments", b"<system-out" not in data)
        self.check(
            "names come through",
            {says(text) for text in HOSTILE} == {suite.getAttribute("name") for suite in suites},
        )
        self.check(
            "an empty submission fails, it is not skipped",
            b"<failure" in junit_xml([ORDINARY[3]]) and b"<skipped" not in junit_xml([ORDINARY[3]]),
        )
        self.check(
            "a submission without stems has its case",
            junit_xml([record("a", [], "crashed")]).count(b"<testcase") == 1,
        )
        if shutil.which("xmllint"):
            self.check(
                "libxml counts the same",
                read_back.xmllint(data, "concat(count(//testcase), ' ', count(//failure))")
                == f"{POINTS * len(HOSTILE)} {3 * len(HOSTILE)}",
            )
        else:
            self.skip("XML as xmllint reads it: xmllint is missing ('make setup' installs it)")

    def test_tap(self):
        data = grades_tap(HOSTILES).encode()
        found = read_back.tap_points(data)
        self.check(
            "TAP has a point per function and per stem without verdicts",
            len(found) == POINTS * len(HOSTILE),
        )
        self.check(
            "only right, waiting and skipped points are ok",
            sum(ok for ok, _ in found) == 3 * len(HOSTILE),
        )
        self.check(
            "no directive but ours",
            sum(bool(re.search(r"(?<!\\)(\\\\)*#", words)) for _, words in found) == len(HOSTILE),
        )
        if read_back.has_perl("TAP::Parser"):
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
            self.check(
                "perl finds the same ones ok",
                sum(line.startswith("ok ") for line in told) == 3 * len(HOSTILE),
            )
            self.check(
                "perl skips what we skip and nothing is TODO",
                sum(line.startswith("ok skip ") for line in told) == len(HOSTILE)
                and not any(
                    line.startswith(("ok todo", "not ok todo", "bail", "unknown")) for line in told
                ),
            )
        else:
            self.skip("TAP as perl reads it: TAP::Parser is missing ('make setup FOR=contributor' installs it)")
