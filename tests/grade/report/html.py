"""html.py - the pages: of one submission, its marks and what to look at in each chapter; of the class, everybody's
marks and what to explain again.

A page is one file that needs no network and no script. It is a tree, xml.etree's, whose HTML writer escapes all text
and attributes: text that goes in is text that comes out, whatever it says. No page is put together from strings.
"""
import base64
import os
import pathlib
import stat
import xml.etree.ElementTree as ElementTree
from itertools import zip_longest
from urllib.parse import quote

from grade.visible import number, score, visible
from .comment import fields, stem_lines
from .figures import (bins, by_exercise, circumstances, handed_in, how_many, most_made, not_answered, of_section, quartiles,
                      sections, stems_of)
from .formats import SUM
from .points import NOTHING, UNSAFE, any_unsafe, clean, clean_class, reason

POLICY = "default-src 'none'; img-src data: 'self'; style-src 'unsafe-inline'"
STYLE = pathlib.Path(__file__).with_name("report.css").read_text(encoding="utf-8")
INLINE = {"a", "abbr", "b", "bdi", "code", "span", "strong", "text"}
CHANGES = 30    # of marks, that are shown
LARGEST_PICTURE = 4_000_000  # bytes; a page should open on a telephone


def tag(name: str, /, *children, **attributes) -> ElementTree.Element:
    """tag('a', 'words', href='...'): class_ is class, aria_label aria-label; None is left out."""
    element = ElementTree.Element(name, {key.rstrip("_").replace("_", "-"): str(value)
                                         for key, value in attributes.items() if value is not None})
    last = None
    for child in children:
        if child is None:
            continue
        if isinstance(child, str):
            if last is None:
                element.text = (element.text or "") + child
            else:
                last.tail = (last.tail or "") + child
        else:
            element.append(child)
            last = child
            if child.tag not in INLINE:
                child.tail = "\n"
    return element


def commas(elements: list) -> list:
    """These, with commas between them."""
    return [part for element in elements for part in (", ", element)][1:]


def table(heads: list, rows: list, caption: str = "", **attributes) -> ElementTree.Element:
    """heads, and the cells of rows: words, or elements."""
    def cell(name: str, what, **more):
        return what if not isinstance(what, str) and what.tag == name else tag(name, what, **more)
    return tag("table", tag("caption", caption) if caption else None,
               tag("thead", tag("tr", *[cell("th", head, scope="col") for head in heads])),
               tag("tbody", *[tag("tr", *[cell("td", what) for what in row]) for row in rows]), **attributes)


def scrolled(label: str, wide) -> ElementTree.Element:
    return tag("div", wide, class_="scroll", tabindex="0", role="region", aria_label=label)


def page(title: str, *body) -> str:
    head = tag("head",
               tag("meta", charset="utf-8"),
               tag("meta", http_equiv="Content-Security-Policy", content=POLICY),
               tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
               tag("meta", name="color-scheme", content="light dark"),
               tag("meta", name="robots", content="noindex"),
               tag("title", title),
               tag("style", STYLE))
    root = tag("html", head, tag("body", *body), lang="en")
    return "<!DOCTYPE html>\n" + ElementTree.tostring(root, "unicode", method="html") + "\n"


def banner(records: list):
    """None where all were graded in a sandbox."""
    if not any_unsafe(records):
        return None
    return tag("p", tag("strong", UNSAFE), class_="unsafe", role="alert")


def address(*parts: str) -> str:
    """A relative URL of files beside the page; the names in it mean nothing but themselves."""
    return "./" + "/".join(quote(os.fsencode(part), safe="") for part in parts)


def read_picture(folder: str, name: str):
    """The bytes of a PNG that lies in the folder as an ordinary file; else None."""
    if not name or name != os.path.basename(name):
        return None
    try:
        handle = os.open(os.path.join(folder, name), os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except (OSError, ValueError):
        return None
    with open(handle, "rb") as file:
        if not stat.S_ISREG(os.fstat(handle).st_mode):
            return None
        data = file.read(LARGEST_PICTURE + 1)
    return data if data.startswith(b"\x89PNG\r\n\x1a\n") and len(data) <= LARGEST_PICTURE else None


def data_url(png: bytes) -> str:
    return "data:image/png;base64," + base64.b64encode(png).decode("ascii")


# ---- one submission -----------------------------------------------------------------------------


def kind(state: str) -> str:
    """The state as a class of the stylesheet."""
    return state.replace(" ", "-")


def share(part: dict) -> str:
    earned, most = part["score"], part["max"]
    return "unasked" if not most else "full" if earned >= most else "none" if earned <= 0 else "some"


def decided(stem: dict):
    """What the instructor has made of the chapter's marks."""
    return tag("div", "decided: " + stem["decided"], class_="quiet") if stem.get("decided") else None


def marks(record: dict):
    rows = []
    for stem in record["stems"]:
        odd = stem["state"] if stem["state"] != "judged" else ""
        rows.append([tag("a", stem["stem"], href="#" + stem["stem"]),
                     tag("td", odd if stem["max"] else "counts nothing", class_="warn" if odd else None),
                     tag("td", score(stem), decided(stem), class_=share(stem))])
    return table(["chapter", tag("th", scope="col", aria_label="state"), "marks"], rows, "Marks by chapter")


def told(stem: dict, function: dict):
    """A function that wants a look: what its comment says, field by field."""
    lines, rows = [], []
    for label, words in fields(stem["stem"], function):
        if not label:
            lines.append(tag("p", ("" if function["state"] == "waiting" else "Should hold: ") + words))
        elif label == "try":
            rows += [tag("dt", label), tag("dd", tag("code", words))]
        else:
            numbers = not function["hidden"] and label not in ("looks like", "you'd see", "but", "it", "asked")
            rows += [tag("dt", label), tag("dd", words, class_="value" if numbers else None)]
    state = tag("span", function["state"], class_=kind(function["state"]))
    return tag("article",
               tag("div", tag("h3", tag("code", function["name"]), " ", state),
                   tag("span", score(function), class_="marks"), class_="head"),
               tag("p", "Slide: " + function["slide"], class_="quiet") if function["slide"] else None,
               *lines,
               tag("dl", *rows) if rows else None,
               class_="told " + kind(function["state"]))


def chapter(stem: dict):
    inside = []
    if stem["file"]:
        inside.append(tag("p", "From ", tag("bdi", stem["file"]), class_="quiet"))
    if stem["state"] == "judged":
        right = [tag("code", function["name"]) for function in stem["functions"] if function["state"] == "right"]
        if right:
            inside.append(tag("p", tag("span", "right ", class_="right"), *commas(right)))
        others = [one for one in stem["functions"] if one["state"] != "right"]
        # As the student's terminal shows them: wrong before unanswered.
        others.sort(key=lambda one: one["state"] in ("unanswered", "waiting"))
        inside += [told(stem, one) for one in others]
    else:
        first, *rest = stem_lines(stem)
        inside.append(tag("p", first[:1].upper() + first[1:].rstrip(":") + ("." if not rest else ":"), class_="warn"))
        if rest:
            inside.append(tag("pre", "\n".join(rest), tabindex="0", aria_label="the message"))
    head = tag("h2", tag("span", stem["stem"]), tag("span", score(stem), class_="marks"), class_="head")
    return tag("section", head, *inside, id=stem["stem"])


def pictures(record: dict, folder: str):
    """Expected beside theirs; None where the submission drew none."""
    found = {which: read_picture(folder, record["pictures"].get(which, "")) for which in ("expected", "yours")}
    if not found["yours"]:
        return None
    figures = [tag("figure", tag("img", src=data_url(png), alt=f"the picture, {which}"), tag("figcaption", which))
               for which, png in found.items() if png]
    theirs = [stem["stem"][:2] for stem in record["stems"] if stem["state"] == "judged"]
    return tag("section", tag("h2", "Your picture"), tag("div", *figures, class_="pair"),
               tag("p", f"Drawn by your chapters {', '.join(theirs)}. The reference answers for the others.", class_="quiet"))


def decisions(record: dict):
    """How the mark is made up, if it is not just what was computed."""
    if not record["decided"]:
        return None
    parts = [f"{label} {number(record[part])}" for label, part in
             (("computed", "computed"), ("late", "penalty"), ("adjusted", "adjusted"), ("final", "score"))]
    return tag("section", tag("p", "; ".join(parts) + "."), tag("ul", *[tag("li", words) for words in record["decided"]]))


def any_wrong(record: dict) -> bool:
    return any(function["state"] != "right" for stem in record["stems"] for function in stem["functions"])


def submission_page(record: dict, folder: str) -> str:
    """folder: where the pictures of the record lie."""
    record = clean(record)
    head = tag("header",
               banner([record]),
               tag("h1", tag("bdi", record["submission"])),
               tag("p", tag("strong", record["status"]), f": {score(record)}", class_="score"),
               *[tag("p", words, class_="warn") for words in (record["words"], record["late"]) if words],
               decisions(record))
    chapters = [chapter(stem) for stem in record["stems"]]
    main = tag("main", marks(record) if chapters else None, pictures(record, folder), *chapters)
    foot = tag("p", "The same verdicts come from ", tag("code", "make exercises"),
               " in your own copy; what was drawn at random here is not in it, so look for the idea,"
               " not for the numbers.", class_="quiet") if any_wrong(record) else None
    return page(f"{record['submission']}: {score(record)}", head, main, tag("footer", foot))


# ---- the class ----------------------------------------------------------------------------------


def link(record: dict):
    name = record["submission"].strip() or record["folder"]
    if record["status"] == NOTHING:
        return tag("bdi", name)
    return tag("a", tag("bdi", name), href=address(record["folder"], "index.html"))


def distribution(records: list):
    """A bar for each tenth, its count above it and its ends below."""
    counted = bins(records)
    most = max(count for _, count in counted) or 1
    shapes = [tag("line", x1=0, y1=120, x2=343, y2=120)]
    for place, (ends, count) in enumerate(counted):
        height = round(100 * count / most, 1)
        middle = 34 * place + 17
        if count:
            shapes.append(tag("rect", x=34 * place + 3, y=120 - height, width=28, height=height))
            shapes.append(tag("text", str(count), x=middle, y=116 - height, text_anchor="middle"))
        shapes.append(tag("text", ends.split("-")[0], x=34 * place + 3, y=134))
    shapes.append(tag("text", "100", x=343, y=134))
    low, middle, high = quartiles(records)
    words = (f"Median {number(middle)} of {number(max(record['max'] for record in records))}; "
             f"the middle half lies between {number(low)} and {number(high)}.")
    label = "; ".join(f"{ends} percent: {count}" for ends, count in counted if count)
    return tag("section", tag("h2", "Scores"), tag("p", words),
               tag("svg", *shapes, viewBox="0 0 366 140", role="img", aria_label=label),
               tag("p", "Submissions by percent of what could be had.", class_="quiet"))


def lecture_figure(name: str):
    if not name:
        return None
    return tag("figure", tag("a", tag("img", src=address("figures", name), alt="an answer of the class, and the right one",
                                      loading="lazy"), href=address("figures", name)),
               tag("figcaption", f"For the lecture: a real answer (“yours”) beside the right one, figures/{name}"), class_="lecture")


def explain_again(records: list, figures: list):
    items = []
    for made, figure in zip_longest(most_made(records), figures, fillvalue=""):
        where = "; ".join(f"{section or 'no section'}: {len(of_section(made['who'], section))}" for section in sections(records))
        items.append(tag("li", tag("b", f"{len(made['who'])} of {len(handed_in(records))}"),
                         f"  {made['stem']} ", tag("code", made["function"]),
                         tag("p", made["sentence"]),
                         tag("p", where, class_="quiet") if where else None,
                         lecture_figure(figure),
                         tag("details", tag("summary", "who"), tag("p", *commas(map(link, made["who"]))))))
    blanks = ", ".join(not_answered(records))
    if not items and not blanks:
        return None
    return tag("section", tag("h2", "What to explain again next week"),
               tag("ol", *items, class_="most") if items else None,
               tag("p", "Not answered, or no file: " + blanks + ".", class_="quiet") if blanks else None)


def exercises(records: list):
    """How many have each function right, also by section."""
    found = by_exercise(records)
    if not found:
        return None
    heads = ["exercise", "everybody", *(section or "no section" for section in sections(records))]
    rows = [[tag("td", f"{stem} ", tag("code", name)), *[f"{right} of {of}" for right, of in groups]] for stem, name, groups in found]
    return tag("section", tag("h2", "By exercise"), tag("details", tag("summary", "how many have it right"), table(heads, rows)))


def row(record: dict, stems: list, sums: tuple):
    found = {stem["stem"]: stem for stem in record["stems"]}
    name = [link(record)]
    if record["status"] != "graded":
        name.append(tag("div", record["status"], class_="warn"))
    if words := reason(record):
        name.append(tag("div", words, class_="quiet"))
    cells = [tag("td", number(found[stem]["score"]), decided(found[stem]), class_=share(found[stem]))
             if stem in found else "" for stem in stems]
    return [tag("td", *name), tag("b", number(record["score"])), *cells, *[number(record[part]) for part in sums]]


def everybody(records: list):
    stems = stems_of(records)
    sums = SUM if any(record["penalty"] or record["adjusted"] for record in records) else ()
    most = max((record["max"] for record in records), default=0)
    heads = ["submission", "final", *[tag("abbr", stem[:2], title=stem) for stem in stems],
             *[{"penalty": "late"}.get(part, part) for part in sums]]
    return tag("section", tag("h2", "Everybody"), scrolled("marks of everybody", table(
        heads, [row(record, stems, sums) for record in records], f"Marks, of {number(most)}, and by chapter")))


def gallery(records: list):
    """Everybody's picture, after the one that was expected."""
    drawn = [record for record in records if record["pictures"].get("yours")]
    if not drawn:
        return None

    def figure(record, which, caption):
        picture = tag("img", src=address(record["folder"], record["pictures"][which]), alt="", loading="lazy")
        return tag("figure", picture, tag("figcaption", caption))

    figures = [figure(record, "yours", link(record)) for record in drawn]
    expected = [record for record in drawn if record["pictures"].get("expected")]
    if expected:
        figures.insert(0, figure(expected[0], "expected", "expected"))
    return tag("section", tag("h2", "Pictures"), tag("div", *figures, class_="pictures"))


def facts(records: list):
    rows = [("class", how_many(records).rstrip(".")), *circumstances(records)]
    files = commas([tag("a", name, href=address(name)) for name in ("grades.csv", "history.csv", "junit.xml")])
    rows = [part for name, value in rows for part in (tag("dt", name), tag("dd", value))]
    return tag("dl", *rows, tag("dt", "also"), tag("dd", *files))


def changes(history):
    """Of marks that were there before, the newest first."""
    changed = [[visible(cell) for cell in row] for row in history if len(row) == 6 and row[5] != "marked"][::-1]
    if not changed:
        return None
    return tag("section", tag("h2", "Changes of marks"), table(
        ["when", "submission", "from", "to", "of", "why"], changed[:CHANGES], "All of them are in history.csv", class_="history"))


def class_page(records: list, history: list = (), figures: list = ()) -> str:
    """history: the changes of marks, the oldest first. figures: of what to explain again, one for each, or ''."""
    records = clean_class(records)
    parts = [distribution(records), explain_again(records, figures), exercises(records), everybody(records), changes(history),
             gallery(records)] if records \
        else [tag("p", "No submissions.")]
    return page("Grades", tag("header", banner(records), tag("h1", "Grades"), facts(records)), tag("main", *parts))
