"""test_report_pages.py - pages hold our tags and their words, reach for nothing, are legible; and a comment says what
'make exercises' prints, and nothing hidden.
"""
import base64
import json
import os
import pathlib
import re
import tempfile
import urllib.parse

from grade.report.comment import fields, fitted, function_lines, stem_lines, stem_says, width
from grade.report.formats import grades_tap, junit_xml, results_json
from grade.report.html import class_page, submission_page
from grade.visible import number, visible
from .fixtures import Sentences
from .read_back import Page
from .records import GIVEN, HOSTILE, MISTAKE, ball, function, hostile_class, ordinary_class, record, stem

GRADING = pathlib.Path(__file__).resolve().parents[1]
HOSTILES, ORDINARY = hostile_class(), ordinary_class()
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


# ---- legible: WCAG 2's contrast, computed from the stylesheet -----------------------------------


def luminance(color: str) -> float:
    parts = [int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    return sum(weight * (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4)
               for weight, part in zip((0.2126, 0.7152, 0.0722), parts))


def contrast(one: str, other: str) -> float:
    light, dark = sorted((luminance(one), luminance(other)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


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
        with tempfile.TemporaryDirectory() as folder:
            one = record("a", [], pictures={"expected": "expected.png", "yours": "yours.png"})
            pathlib.Path(folder, "expected.png").write_bytes(ball(0.8))
            yours = pathlib.Path(folder, "yours.png")

            def sources():
                return [url for key, url in Page(submission_page(one, folder)).urls if key == "src"]

            self.check("without a picture there is none", sources() == [])
            yours.write_bytes(ball(0.4))
            self.check("pictures are in the page, expected beside yours", sources()
                       == ["data:image/png;base64," + base64.b64encode(png).decode() for png in (ball(0.8), ball(0.4))])
            secret = pathlib.Path(folder, "secret.png")
            secret.write_bytes(ball(0.4))
            for what, put in (("no PNG", lambda: yours.write_bytes(b"<svg onload='alert(1)'>")),
                              ("a link", lambda: yours.symlink_to(secret)), ("a pipe", lambda: os.mkfifo(yours))):
                yours.unlink()
                put()
                self.check(f"{what} in a picture's place is not shown", sources() == [])
            one["pictures"]["yours"] = "../" + os.path.basename(folder) + "/secret.png"
            self.check("a picture lies beside its page and nowhere else", sources() == [])

    def test_class(self):
        for them in (HOSTILES, ORDINARY, []):
            page = Page(class_page(them))
            self.check(f"the page of {len(them)} has our tags, attributes and addresses only", is_ours(page))
        page = Page(class_page(HOSTILES))
        self.check("the class has a row each", page.tags.count("tr") == 1 + len(HOSTILE))
        self.check("names come through in the class", all(visible(text) in words(page) for text in HOSTILE))
        odd = ["a b", "50%", "#1", "javascript:alert(1)", "q?x=1&y", "näive", os.fsdecode(b"caf\xe9")]
        page = Page(class_page([record("x", [], folder=name) for name in odd]))
        links = {url for _, url in page.urls if url.endswith("/index.html")}
        self.check("links lead to folders with odd names", is_ours(page)
                   and {os.fsdecode(urllib.parse.unquote_to_bytes(url)) for url in links}
                   == {f"./{name}/index.html" for name in odd})
        self.check("a link is called by its submission",
                   '<a href="./f/index.html"><bdi>a name</bdi></a>' in class_page([record("a name", [], folder="f")]))
        told = words(Page(class_page(ORDINARY)))
        self.check("the class's page says seed and sandbox",
                   "123456" in told and "bubblewrap, Landlock, seccomp" in told)
        self.check("the class's page is the same in any order", class_page(ORDINARY[::-1]) == class_page(ORDINARY))
        for page in (lambda one: class_page([one]), lambda one: submission_page(one, ".")):
            self.check("a page says when marks are unsafe", "UNSAFE" in page({**ORDINARY[0], "unsafe": True})
                       and "UNSAFE" not in page(ORDINARY[0]))

    def test_style(self):
        css = (GRADING / "report/report.css").read_text(encoding="utf-8")
        found = [dict(re.findall(r"--([a-z-]+): (#[0-9a-f]{6});", block)) for block in css.split(":root {")[1:]]
        schemes = {"light": found[0], "dark": {**found[0], **found[1]}}
        self.check("black on white is 21 to 1", round(contrast("#000000", "#ffffff"), 3) == 21)
        pairs = [(ink, ground, 4.5) for ink in ("ink", "quiet", "link", "good", "bad", "warn") for ground in ("paper", "box")]
        for name, colors in schemes.items():
            for ink, ground, least in [*pairs, ("alarm-ink", "alarm", 4.5), ("bar", "paper", 3)]:
                self.check(f"{ink} is legible on {ground} in the {name} scheme",
                           contrast(colors[ink], colors[ground]) >= least)
        rules = css.split("* { box-sizing", 1)[1]
        self.check("no colour is outside the schemes", not re.search(r"#[0-9a-f]{3,6}\b|rgb|url\(", rules))


# ---- comments -----------------------------------------------------------------------------------


README = pathlib.Path(__file__).resolve().parents[3] / "exercises/README.md"
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
                "junit.xml": junit_xml([one]).decode(), "grades.tap": grades_tap([one])}
        for name, text in told.items():
            self.check(f"{name} describes a hidden input and does not print it",
                       not any(canary in text for canary in ("8.12345", "CANARY"))
                       and "inputs drawn at random for this run" in text and "the upper right corner of the example" in text)
        self.check("a mistake is named all the same", fields("01-corners", hidden)[2][0] == "looks like")
