"""test_reports.py - nothing that a student wrote forges a result in JSON, XML or CSV, acts on a terminal, or is
more than words on a page; a comment says what 'make exercises' prints, and nothing hidden; a file is whole or not there.
"""
import base64
import codecs
import csv
import io
import json
import os
import random
import re
import subprocess
import sys
import time
import urllib.parse
import xml.dom.minidom
from pathlib import Path
from unittest import mock

from grade.report import files
from grade.report.comment import fields, fitted, function_lines, stem_lines, stem_says, width
from grade.report.formats import grades_csv, junit_xml, results_json
from grade.report.html import class_page, submission_page
from grade.report.points import clean
from grade.report.text import closing
from grade.visible import number, visible
from .fixtures import Page, Sentences
from .records import GIVEN, HOSTILE, MISTAKE, function, hostile_class, hostile_record, ordinary_class, record, stem

PACKAGES = Path(__file__).resolve().parents[2]
HOSTILES, ORDINARY = hostile_class(), ordinary_class()
PICTURES = {name: b"\x89PNG\r\n\x1a\n" + name.encode() for name in ("expected", "yours")}
POINTS = 10  # of each hostile record: four stems that were not judged, six functions


def gradescope(one: dict) -> dict:
    return json.loads(results_json(one), parse_constant=lambda name: 1 / 0)


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
        self.check("what cannot be read is 0 for Gradescope, which shows no reason without a score",
                   gradescope(whole)["score"] == 0 and whole["score"] is None)
        self.check("what is read in part has the marks of the rest", len(gradescope(partly)["tests"]) > 1
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


# ---- the grade book, the terminal, and all of them ----------------------------------------------


# No C0 or C1 except line ends, no characters that break or reverse lines, and no invalid ones.
NO_CONTROLS = re.compile("[^\x00-\x09\x0b-\x1f\x7f-\x9f" "\u2028\u2029\u202a-\u202e\u2066-\u2069\ufeff\ufffe\uffff]*")


def strict_csv(data: bytes) -> list:
    """After the mark by which Excel knows UTF-8; CRLF ends each record."""
    assert data.startswith(codecs.BOM_UTF8)
    text = data.decode("utf-8-sig")
    assert "\n" not in re.sub(r'"[^"]*"', "", text).replace("\r\n", "")
    return list(csv.reader(io.StringIO(text, newline=""), strict=True))


class ReportTables(Sentences):
    def test_csv(self):
        data = grades_csv(HOSTILES).encode()
        rows = strict_csv(data)
        self.check("the grade book has one row per submission", len(rows) == 1 + len(HOSTILE))
        self.check("its columns are submission, status, final, max, the stems, what the final mark is made of, the reason",
                   rows[0] == ["submission", "status", "final", "max", "01-corners", "02-cameras", "03-screen",
                               "04-pixel-ray", "05-quadratic", "computed", "late", "adjusted", "reason"])
        self.check("all rows are as wide", {len(row) for row in rows} == {13})
        self.check("marks are in their columns",
                   all(row[1:-1] == ["crashed", "8", "80", "0", "0", "0", "0", "8", "8", "0", "0"] for row in rows[1:]))
        sums = grades_csv([record("a", [stem("01-corners", [function("upper_left")])], score=4.5, penalty=-1, adjusted=1.5)])
        self.check("the columns add up", strict_csv(sums.encode())[1][2:-1] == ["4.5", "4", "4", "4", "-1", "1.5"], sums)
        self.check("no cell is run by a spreadsheet",
                   not any(re.match(r"\s*[=+\-@\t\r＝＋－＠]", cell) for row in rows for cell in row))
        self.check("nor where semicolons part cells",
                   not any(re.search(r"(^|;)\s*[=+\-@]", re.sub(r'"([^"]|"")*"', "", line))
                           for line in data.decode("utf-8-sig").split("\r\n")))
        self.check("such a name is written after an apostrophe", "'=cmd|' /C calc'!A0" in {row[0] for row in rows})
        lacking = grades_csv([record("a", [stem("01-corners", [function("upper_left")])]), record("b", [])])
        self.check("whoever lacks a stem has 0 there",
                   strict_csv(lacking.encode())[2] == ["b", "graded", "0", "0", "0", "0", "0", "0", ""])

    def test_text(self):
        for name, them in (("hostile", HOSTILES), ("ordinary", ORDINARY), ("empty", []),
                           ("long", ordinary_class(300, 7) + HOSTILES)):
            told = closing(them)
            self.check(f"the closing table of the {name} class fits a terminal",
                       all(width(line) <= 79 for line in told.splitlines()))
            self.check(f"nothing in that of the {name} class drives the terminal", NO_CONTROLS.fullmatch(told))
        told = closing(ordinary_class(300, 7)).splitlines()
        self.check("a long class is shortened", len(told) < 80 and any("more; above are" in line for line in told))
        # 1 to 8: by hand, the quartiles that include both ends are 2.75, 4.5, 6.25.
        eight = [record(f"g{n}", [stem("01-corners", [function("upper_left", most=8.0)])], score=float(n))
                 for n in range(1, 9)]
        self.check("the median and the quartiles are right",
                   "median 4.5 of 8, the middle half from 2.75 to 6.25" in closing(eight))
        nobody = record("h", [], "nothing handed in", folder="", max=8.0, person={"id": "9"})
        self.check("who handed in nothing does not count in them", "median 4.5 of 8, " in closing([*eight, nobody]))

    def test_all(self):
        reports = {"grades.csv": grades_csv, "junit.xml": lambda them: junit_xml(them).decode(), "terminal": closing}
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


# ---- pages ---------------------------------------------------------------------------------------


TAGS = set("html head meta title style body header main footer section article div h1 h2 h3 p a b bdi span strong code pre "
           "dl dt dd ul ol li table caption thead tbody tr th td abbr figure figcaption img svg line rect text details "
           "summary".split())
ATTRIBUTES = set("charset http-equiv content name lang class href id scope aria-label role tabindex title src alt loading "
                 "x y x1 x2 y1 y2 width height text-anchor viewbox".split())
POLICY = "default-src 'none'; img-src data: 'self'; style-src 'unsafe-inline'"
BESIDE = re.compile(r"\./[A-Za-z0-9._~%/-]+")  # nothing but a relative path, however odd a name


def urls_are_ours(page: Page) -> bool:
    return all(BESIDE.fullmatch(url) or (key == "href" and re.fullmatch(r"#\d\d-[a-z-]+", url))
               or (key == "src" and re.fullmatch(r"data:image/png;base64,[A-Za-z0-9+/=]+", url))
               for key, url in page.urls)


def is_ours(page: Page) -> bool:
    return (set(page.tags) <= TAGS and page.attributes <= ATTRIBUTES and not page.other and not page.open
            and urls_are_ours(page))


def words(page: Page) -> str:
    return "".join(page.words)


class ReportPages(Sentences):
    def test_submissions(self):
        texts = [submission_page(one, "/nonexistent") for one in HOSTILES]
        pages = [Page(text) for text in texts]
        self.check("a submission's page, which its student gets alone, leads to no other file",
                   not any(url.startswith(".") for one in pages for _, url in one.urls))
        self.check("a hostile submission's page has our tags, attributes and addresses only", all(map(is_ours, pages)))
        self.check("all hostile pages have the same tags",
                   len({tuple(page.tags) for page, text in zip(pages, HOSTILE) if text.strip()}) == 1)
        self.check("names come through as words",
                   all(visible(text) in words(page) for page, text in zip(pages, HOSTILE)))
        self.check("a page is headed by its submission",
                   "<h1><bdi>a name</bdi></h1>" in submission_page(record("a name", [], folder="f"), "."))
        self.check("no control characters in a page",
                   not any(re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202e\u2066\ufeff]", text) for text in texts))
        self.check("a page allows no script and no network", all(f'content="{POLICY}"' in text for text in texts))
        functions = [function("blank_one", state="unanswered"), function("wrong_one", state="wrong", test="t")]
        page = submission_page(record("a", [stem("01-corners", functions)]), ".")
        self.check("wrong comes before unanswered", page.index("wrong_one") < page.index("blank_one"))
        page = words(Page(submission_page(ORDINARY[6], ".")))
        self.check("the compiler's words are shown", "error: expected ';' before 'return'\n   31 |" in page)
        marks = "{score:g} of {max:g}".format(**ORDINARY[6])
        self.check("status and marks are shown", f"does not compile: {marks}" in page, marks)
        self.check("it says where the same verdict comes from", "make exercises" in page)
        self.check("a late one says what that cost", "2 days late" in words(Page(submission_page(ORDINARY[2], "."))))
        self.check("the seed, which gives hidden inputs away, is not on it", "123456" not in page)

    def test_pictures(self):
        one = record("a", [], pictures={"expected": "expected.png", "yours": "yours.png"})
        (self.work / "expected.png").write_bytes(PICTURES["expected"])
        yours = self.work / "yours.png"

        def sources():
            return [url for key, url in Page(submission_page(one, str(self.work))).urls if key == "src"]

        self.check("without a picture there is none", sources() == [])
        yours.write_bytes(PICTURES["yours"])
        self.check("pictures are in the page, expected beside yours", sources()
                   == ["data:image/png;base64," + base64.b64encode(png).decode() for png in PICTURES.values()])
        secret = self.work / "secret.png"
        secret.write_bytes(PICTURES["yours"])
        for what, put in (("no PNG", lambda: yours.write_bytes(b"<svg onload='alert(1)'>")),
                          ("a link", lambda: yours.symlink_to(secret)), ("a pipe", lambda: os.mkfifo(yours))):
            yours.unlink()
            put()
            self.check(f"{what} in a picture's place is not shown", sources() == [])
        one["pictures"]["yours"] = f"../{self.work.name}/secret.png"
        self.check("a picture lies beside its page and nowhere else", sources() == [])

    def test_class(self):
        for them in (HOSTILES, ORDINARY, []):
            page = Page(class_page(them))
            self.check(f"the page of {len(them)} has our tags, attributes and addresses only", is_ours(page))
        page = Page(class_page(HOSTILES))
        exercises = 1 + 6   # rows of the functions of 05
        self.check("the class has a row each", page.tags.count("tr") == 1 + len(HOSTILE) + exercises)
        self.check("names come through in the class", all(visible(text) in words(page) for text in HOSTILE))
        odd = ["a b", "50%", "#1", "javascript:alert(1)", "q?x=1&y", "näive", os.fsdecode(b"caf\xe9")]
        page = Page(class_page([record("x", [], folder=name) for name in odd]))
        links = {url for _, url in page.urls if url.endswith("/index.html")}
        self.check("links lead to folders with odd names", is_ours(page)
                   and {os.fsdecode(urllib.parse.unquote_to_bytes(url)) for url in links}
                   == {f"./{name}/index.html" for name in odd})
        self.check("a link is called by its submission",
                   '<a href="./f/index.html"><bdi>a name</bdi></a>' in class_page([record("a name", [], folder="f")]))
        one = record("a", [stem("01-corners", [function("upper_left", most=15.0)], decided="12 of 15"), stem("04-pixel-ray", state="missing",
                           most=7.0, decided="excused")])
        for page in (submission_page(one, "."), class_page([one])):
            told = words(Page(page))
            self.check("what is decided on a chapter is beside its marks", "decided: 12 of 15" in told and "decided: excused" in told, told[-300:])
        self.check("a page without a wrong answer does not speak of verdicts", "The same verdicts" not in submission_page(one, ".")
                   and "The same verdicts" in submission_page(ORDINARY[0], "."))
        many = [record("a", [stem("05-quadratic", [function(f"f{at}", state="unanswered") for at in range(11)])])]
        self.check("what is not listed is counted", "05-quadratic f6 (1), and 3 more" in " ".join(class_page(many).split()))
        told = words(Page(class_page(ORDINARY)))
        self.check("the class's page says seed and sandbox",
                   "123456" in told and "bubblewrap, Landlock, seccomp" in told)
        sections = [record(str(at), [stem("01-corners", [function("upper_left", state="right" if at < 3 else "wrong")])],
                           person={"section": "Monday" if at % 2 else ""}) for at in range(7)]
        told = re.sub(r"\s+", " ", words(Page(class_page(sections))))
        self.check("each section has its share", "everybody no section Monday 01-corners upper_left 3 of 7 2 of 4 1 of 3" in told, told[-800:])
        self.check("the class's page is the same in any order", class_page(ORDINARY[::-1]) == class_page(ORDINARY))
        for page in (lambda one: class_page([one]), lambda one: submission_page(one, ".")):
            self.check("a page says when marks are unsafe", "UNSAFE" in page({**ORDINARY[0], "unsafe": True})
                       and "UNSAFE" not in page(ORDINARY[0]))


# ---- comments -----------------------------------------------------------------------------------


README = PACKAGES.parent / "exercises/README.md"
UPPER_RIGHT = function("upper_right", "Finding vectors from the eye", "Give an expression.", "wrong", mistake=MISTAKE,
                       test="the_upper_right_corner_of_the_example", expected="(1, 1, 4)", yours="(2, 2, 4)", given=GIVEN[:1])


class Comment(Sentences):
    def test_visible(self):
        raw = ("a\0\x1b[2J\n\t\r\x7f\x85" + os.fsdecode(b"\xff")
               + "\ud800\u2028\u202e\ufeff\uffff\U000e0041 \u00e9\u5b57\\n")
        self.check("what acts is shown and does not act", visible(raw)
                   == (r"a\x00\x1b[2J\n\t\r\x7f\x85\xff\ud800\u2028\u202e\ufeff\uffff\U000e0041 " + "\u00e9\u5b57\\n"))
        self.check("lines stay where they are wanted", visible("a\r\nb\x07\n\tc", lines=True) == "a\nb\\x07\n        c")
        self.check("what is too long is cut, and says so", visible("x" * 10_001) == "x" * 10_000 + " ... (cut)")
        self.check("columns are counted as a terminal does",
                   [width(text) for text in ("ab", "\u5b57", "e\u0301")] == [2, 2, 1])
        self.check("a name that is too long ends in two dots",
                   [fitted(text, 5) for text in ("abcdef", "\u5b57" * 3, "ab")] == ["abc..", "\u5b57.. ", "ab   "])
        self.check("marks are written as people write them",
                   [number(x) for x in (74.0, 18.5, 1 / 3, 0.0, -0.0, 100)] == ["74", "18.5", "0.33", "0", "0", "100"])

    def test_words(self):
        block = README.read_text(encoding="utf-8").split("    01-corners  upper_right ")[1].split("\n\n")[0]
        # The page has no formula of a mistake, because the students' archive has none.
        block = block.replace("looks like a known mistake:", "looks like d f + w r + h u:")
        # A figure is drawn where the student is, not where somebody grades.
        wanted = [line[4:] for line in block.split("\n")[1:] if not line.startswith("      see ")]
        self.check("a comment is what the students' page shows of 'make exercises', but for the figure",
                   function_lines("01-corners", UPPER_RIGHT) == wanted)
        self.check("of what is right there is nothing to say", function_lines("01-corners", function("a")) == [])
        waiting = function("hit_sphere", state="waiting", waiting_for=["quadratic_roots"])
        self.check("what waits says for what, and has its marks",
                   function_lines("05-quadratic", waiting) == ["  right once quadratic_roots is; it has its marks"])
        waiting["waiting_for"] += ["sphere_roots"]
        self.check("and for several", fields("05-quadratic", waiting)
                   == [("", "right once quadratic_roots and sphere_roots are; it has its marks")])
        self.check("a blank says what is asked",
                   fields("01-corners", {**UPPER_RIGHT, "state": "unanswered"})
                   == [("asked", "Give an expression."), ("try", "make hint EX=01")])
        endless = {**UPPER_RIGHT, "state": "timed out", "how": "was still running after 1 s (an endless loop?)"}
        self.check("an endless loop is not diagnosed, but looked for",
                   function_lines("01-corners", endless)[-2:]
                   == ["  it         was still running after 1 s (an endless loop?)", "  try        make debug EX=01"])
        self.check("a second mistake is not kept secret", "(Something else is also not right yet.)"
                   in " ".join(function_lines("01-corners", {**UPPER_RIGHT, "partly": True})))
        law = {**UPPER_RIGHT, "mistake": None, "law": "it is not in the plane"}
        self.check("without a known mistake the comment names the broken law",
                   ("but", "it is not in the plane") in fields("01-corners", law))
        long = {**UPPER_RIGHT, "given": [["camera", "eye~(" + "2" * 45 + ", 2), right~(1, 0, 0)"]]}
        self.check("a long vector is not broken", "             right (1, 0, 0)" in function_lines("01-corners", long))

    def test_stems(self):
        twice = stem("02-cameras", state="twice", words="a/02-cameras.c\nb/02-cameras.c\n")
        self.check("two files of one name are both named", stem_lines(twice)
                   == ["there is more than one file called 02-cameras.c, and which is meant is not guessed:",
                       "a/02-cameras.c", "b/02-cameras.c"])
        self.check("a missing file is named",
                   stem_lines(stem("02-cameras", state="missing")) == ["no 02-cameras.c was found"])
        self.check("a judged stem has nothing to say", stem_says(stem("02-cameras")) == "")

    def test_hidden(self):
        # Though the record holds what it should not.
        hidden = {**UPPER_RIGHT, "hidden": True, "expected": "CANARY", "yours": "8.12345", "law": "8.12345",
                  "given": [["camera", "CANARY"]]}
        bare = {**hidden, "mistake": None}
        one = record("a", [stem("01-corners", [hidden, {**bare, "name": "upper_left"}])])
        results = json.loads(results_json(one))
        del results["extra_data"]
        told = {"index.html": submission_page(one, "."), "results.json": json.dumps(results),
                "junit.xml": junit_xml([one]).decode()}
        for name, text in told.items():
            self.check(f"{name} describes a hidden input and does not print it",
                       not any(canary in text for canary in ("8.12345", "CANARY"))
                       and "inputs drawn at random for this run" in text and "the upper right corner of the example" in text)
        self.check("a mistake is named all the same", fields("01-corners", hidden)[2][0] == "looks like")


# ---- files ---------------------------------------------------------------------------------------


CLASS = {"grades.csv", "junit.xml", "index.html"}


def contents(folder: Path) -> dict:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


class ReportFiles(Sentences):
    def test_round_trip(self):
        them = hostile_class() + ordinary_class()
        for one in them:
            files.write_submission(one, str(self.work / one["folder"]))
        read = [files.read_record(str(self.work / one["folder"] / "results.json")) for one in them]
        self.check("a record that was written is read as it was", read == [clean(one) for one in them])
        files.write_class(them, str(self.work))
        before = contents(self.work)
        files.write_class(read[::-1], str(self.work))
        self.check("class reports from what was read, in another order, are the same bytes", before == contents(self.work))
        self.check("a submission has its two files, the class its reports, and nothing else is left", set(before) == CLASS | {
            f"{one['folder']}/{name}" for one in them for name in ("index.html", "results.json")}, list(before))
        os.rename(self.work / "h00", self.work / "moved")
        self.check("a folder that was renamed is found again",
                   files.read_record(str(self.work / "moved" / "results.json"))["folder"] == "moved")

    def test_hash_seeds(self):
        # Python's sets and hashes differ from run to run; what is written must not.
        program = ("import sys; from grade.check import records; from grade.report import files;"
                   "files.write_class(records.ordinary_class(), sys.argv[1]);"
                   "files.write_submission(records.hostile_class()[9], sys.argv[1] + '/one');")
        written = []
        for seed in ("1", "2"):
            subprocess.run([sys.executable, "-B", "-c", program, self.work / seed], check=True, cwd=PACKAGES,
                           env={**os.environ, "PYTHONHASHSEED": seed, "LC_ALL": "C"})
            written.append(contents(self.work / seed))
        self.check("two runs write the same bytes, whatever the locale", written[0] == written[1] and len(written[0]) == 5)

    def test_whole_or_not(self):
        one, out = ordinary_class()[0], str(self.work)
        files.write_submission(one, out)
        before = contents(self.work)
        with self.assertRaises(ValueError):     # a mark that is none
            files.write_submission({**one, "submission": "b", "score": float("inf")}, out)
        with self.assertRaises(OSError), mock.patch("os.replace", side_effect=OSError("disk full")):
            files.write_submission({**one, "submission": "b"}, out)
        self.check("if it fails, the older files stay, alone", before == contents(self.work))
        with mock.patch("os.replace", side_effect=os.replace) as replaced:
            files.write_submission(one, out)
        self.check("results.json comes last", [os.path.basename(call.args[1]) for call in replaced.call_args_list]
                   == ["index.html", "results.json"])
        fresh, old = self.work / ".index.html.1.new", self.work / ".index.html.2.new"
        fresh.touch()
        old.touch()
        os.utime(old, (time.time() - 7200,) * 2)
        files.write_submission(one, out)
        self.check("what a killed grader left is cleared away, another's work is not", fresh.exists() and not old.exists())

    def test_no_record(self):
        path = self.work / "results.json"
        for words in ("", "{", "[]", "null", "{}", '{"extra_data": 1}', '{"extra_data": {"record": []}}', "\x00"):
            path.write_text(words, encoding="utf-8")
            with self.subTest(f"no record is found in {words!r}"), self.assertRaises(ValueError):
                files.read_record(str(path))
