"""test_report_pages.py - pages hold our tags and their words, reach for nothing, are legible."""
import base64
import os
import pathlib
import re
import tempfile
import urllib.parse

from grade.report.html import submission_page
from grade.report.html_class import class_page
from grade.visible import visible
from .hostile_records import HOSTILE, hostile_class
from .make_records import ball, function, record, stem
from .read_back import Page
from .sample_records import ordinary_class
from .sentences import Sentences

GRADING = pathlib.Path(__file__).resolve().parents[1]
HOSTILES, ORDINARY = hostile_class(), ordinary_class()
TAGS = set(
    """html head meta title style body header main footer section article div h1 h2 h3 p a b bdi
    span strong code pre dl dt dd ul ol li table caption thead tbody tr th td abbr figure figcaption
    img svg line rect text details summary""".split()
)
ATTRIBUTES = set(
    """charset http-equiv content name lang class href id scope aria-label role tabindex title
    src alt loading x y x1 x2 y1 y2 width height text-anchor viewbox""".split()
)
POLICY = "default-src 'none'; img-src data: 'self'; style-src 'unsafe-inline'"
BESIDE = re.compile(r"\./[A-Za-z0-9._~%/-]+")  # nothing but a relative path, however odd a name


def urls_are_ours(page: Page) -> bool:
    return all(
        BESIDE.fullmatch(url)
        or (key == "href" and re.fullmatch(r"#\d\d-[a-z-]+", url))
        or (key == "src" and re.fullmatch(r"data:image/png;base64,[A-Za-z0-9+/=]+", url))
        for key, url in page.urls
    )


def is_ours(page: Page) -> bool:
    return (
        set(page.tags) <= TAGS
        and page.attributes <= ATTRIBUTES
        and not page.other
        and not page.open
        and urls_are_ours(page)
    )


def words(page: Page) -> str:
    return "".join(page.words)


# ---- legible: WCAG 2's contrast, computed from the stylesheet -----------------------------------


def luminance(color: str) -> float:
    parts = [int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    return sum(
        weight * (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4)
        for weight, part in zip((0.2126, 0.7152, 0.0722), parts)
    )


def contrast(one: str, other: str) -> float:
    light, dark = sorted((luminance(one), luminance(other)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


class ReportPages(Sentences):
    def test_submissions(self):
        texts = [submission_page(one, "/nonexistent") for one in HOSTILES]
        pages = [Page(text) for text in texts]
        self.check(
            "a submission's page, which its student gets alone, leads to no other file",
            not any(url.startswith(".") for one in pages for _, url in one.urls),
        )
        self.check(
            "a hostile submission's page has our tags, attributes and addresses only",
            all(map(is_ours, pages)),
        )
        self.check(
            "all hostile pages have the same tags",
            len({tuple(page.tags) for page, text in zip(pages, HOSTILE) if text.strip()}) == 1,
        )
        self.check(
            "names come through as words",
            all(visible(text) in words(page) for page, text in zip(pages, HOSTILE)),
        )
        self.check(
            "a page is headed by its submission",
            "<h1><bdi>a name</bdi></h1>" in submission_page(record("a name", [], folder="f"), "."),
        )
        self.check(
            "no control characters in a page",
            not any(
                re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202e\u2066\ufeff]", text) for text in texts
            ),
        )
        self.check(
            "a page allows no script and no network",
            all(f'content="{POLICY}"' in text for text in texts),
        )
        functions = [
            function("blank_one", state="unanswered"),
            function("wrong_one", state="wrong", test="t"),
        ]
        page = submission_page(record("a", [stem("01-corners", functions)]), ".")
        self.check("wrong comes before unanswered", page.index("wrong_one") < page.index("blank_one"))
        page = words(Page(submission_page(ORDINARY[6], ".")))
        self.check("the compiler's words are shown", "error: expected ';' before 'return'\n   31 |" in page)
        marks = "{score:g} of {max:g}".format(**ORDINARY[6])
        self.check("status and marks are shown", f"does not compile: {marks}" in page, marks)
        self.check("it says where the same verdict comes from", "make exercises" in page)
        self.check(
            "a late one says what that cost",
            "2 days late" in words(Page(submission_page(ORDINARY[2], "."))),
        )
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
            self.check(
                "pictures are in the page, expected beside yours",
                sources()
                == [
                    "data:image/png;base64," + base64.b64encode(png).decode()
                    for png in (ball(0.8), ball(0.4))
                ],
            )
            yours.write_bytes(b"<svg onload='alert(1)'>")
            self.check("what is no PNG is not shown", sources() == [])
            yours.unlink()
            secret = pathlib.Path(folder, "secret.png")
            secret.write_bytes(ball(0.4))
            yours.symlink_to(secret)
            self.check("a link in a picture's place is not followed", sources() == [])
            yours.unlink()
            os.mkfifo(yours)
            self.check("nor a pipe waited for", sources() == [])
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
        self.check(
            "links lead to folders with odd names",
            is_ours(page)
            and {os.fsdecode(urllib.parse.unquote_to_bytes(url)) for url in links}
            == {f"./{name}/index.html" for name in odd},
        )
        self.check(
            "a link is called by its submission",
            '<a href="./f/index.html"><bdi>a name</bdi></a>'
            in class_page([record("a name", [], folder="f")]),
        )
        told = words(Page(class_page(ORDINARY)))
        self.check(
            "the class's page says seed and sandbox",
            "123456" in told and "bubblewrap, Landlock, seccomp" in told,
        )
        self.check(
            "the class's page is the same in any order",
            class_page(ORDINARY[::-1]) == class_page(ORDINARY),
        )
        for what, safe, unsafe in (
            ("class", class_page(ORDINARY), class_page([{**ORDINARY[0], "unsafe": True}])),
            (
                "submission",
                submission_page(ORDINARY[0], "."),
                submission_page({**ORDINARY[0], "unsafe": True}, "."),
            ),
        ):
            self.check(
                f"the page of a {what} says when marks are unsafe",
                "UNSAFE" in unsafe and "UNSAFE" not in safe,
            )

    def test_style(self):
        css = (GRADING / "report/report.css").read_text(encoding="utf-8")
        found = [
            dict(re.findall(r"--([a-z-]+): (#[0-9a-f]{6});", block))
            for block in css.split(":root {")[1:]
        ]
        schemes = {"light": found[0], "dark": {**found[0], **found[1]}}
        self.check("black on white is 21 to 1", round(contrast("#000000", "#ffffff"), 3) == 21)
        for name, colors in schemes.items():
            for ink in ("ink", "quiet", "link", "good", "bad", "warn"):
                self.check(
                    f"{ink} is legible in the {name} scheme",
                    contrast(colors[ink], colors["paper"]) >= 4.5
                    and contrast(colors[ink], colors["box"]) >= 4.5,
                )
            self.check(
                f"the alarm is legible in the {name} scheme",
                contrast(colors["alarm-ink"], colors["alarm"]) >= 4.5,
            )
            self.check(
                f"bars are visible on the {name} paper", contrast(colors["bar"], colors["paper"]) >= 3
            )
        rules = css.split("* { box-sizing", 1)[1]
        self.check(
            "no colour is outside the schemes", not re.search(r"#[0-9a-f]{3,6}\b|rgb|url\(", rules)
        )
