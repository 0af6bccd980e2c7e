"""html_class.py - the page of the class: everybody's marks, and what to explain again."""
from grade.visible import number
from .figures import bins, circumstances, most_made, not_answered, quartiles, stems_of
from .html import share
from .points import clean_class
from .tree import address, banner, page, tag


def link(record: dict):
    return tag(
        "a",
        tag("bdi", record["submission"].strip() or record["folder"]),
        href=address(record["folder"], "index.html"),
    )


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
    words = (
        f"Median {number(middle)} of {number(max(record['max'] for record in records))}; "
        f"the middle half lies between {number(low)} and {number(high)}."
    )
    label = "; ".join(f"{ends} percent: {count}" for ends, count in counted if count)
    return tag(
        "section",
        tag("h2", "Scores"),
        tag("p", words),
        tag("svg", *shapes, viewBox="0 0 366 140", role="img", aria_label=label),
        tag("p", "Submissions by percent of what could be had.", class_="quiet"),
    )


def explain_again(records: list):
    items = []
    for made in most_made(records):
        who = []
        for record in made["who"]:
            who += [", " if who else "", link(record)]
        items.append(
            tag(
                "li",
                tag("b", f"{len(made['who'])} of {len(records)}"),
                f"  {made['stem']} ",
                tag("code", made["function"]),
                tag("p", made["sentence"]),
                tag("details", tag("summary", "who"), tag("p", *who)),
            )
        )
    blanks = ", ".join(f"{what} ({count})" for what, count in not_answered(records))
    if not items and not blanks:
        return None
    return tag(
        "section",
        tag("h2", "What to explain again next week"),
        tag("ol", *items, class_="most") if items else None,
        tag("p", "Not answered, or no file: " + blanks + ".", class_="quiet") if blanks else None,
    )


def row(record: dict, stems: list):
    found = {stem["stem"]: stem for stem in record["stems"]}
    name = [link(record)]
    for words, style in (
        (record["status"] if record["status"] != "graded" else "", "warn"),
        (record["late"], "quiet"),
    ):
        if words:
            name.append(tag("div", words, class_=style))
    cells = [
        tag(
            "td",
            number(found[stem]["score"]),
            class_=share(found[stem]["score"], found[stem]["max"]),
        )
        if stem in found
        else tag("td", "")
        for stem in stems
    ]
    return tag("tr", tag("td", *name), tag("td", tag("b", number(record["score"]))), *cells)


def everybody(records: list):
    stems = stems_of(records)
    most = max((record["max"] for record in records), default=0)
    heads = [tag("th", tag("abbr", stem[:2], title=stem), scope="col") for stem in stems]
    table = tag(
        "table",
        tag("caption", f"Marks, of {number(most)}, and by chapter"),
        tag(
            "thead",
            tag(
                "tr", tag("th", "submission", scope="col"), tag("th", "score", scope="col"), *heads
            ),
        ),
        tag("tbody", *[row(record, stems) for record in records]),
    )
    return tag(
        "section",
        tag("h2", "Everybody"),
        tag(
            "div",
            table,
            class_="scroll",
            tabindex="0",
            role="region",
            aria_label="marks of everybody",
        ),
    )


def gallery(records: list):
    """Everybody's picture, after the one that was expected."""
    drawn = [record for record in records if record["pictures"].get("yours")]
    if not drawn:
        return None

    def figure(record, which, caption):
        return tag(
            "figure",
            tag(
                "img",
                src=address(record["folder"], record["pictures"][which]),
                alt="",
                loading="lazy",
            ),
            tag("figcaption", caption),
        )

    figures = [figure(record, "yours", link(record)) for record in drawn]
    expected = [record for record in drawn if record["pictures"].get("expected")]
    if expected:
        figures.insert(0, figure(expected[0], "expected", "expected"))
    return tag("section", tag("h2", "Pictures"), tag("div", *figures, class_="pictures"))


def facts(records: list):
    rows = [("class", f"{len(records)} submissions"), *circumstances(records)]
    files = []
    for name in ("grades.csv", "junit.xml", "grades.tap"):
        files += [", " if files else "", tag("a", name, href=address(name))]
    return tag(
        "dl",
        *[part for name, value in rows for part in (tag("dt", name), tag("dd", value))],
        tag("dt", "also"),
        tag("dd", *files),
    )


def class_page(records: list) -> str:
    records = clean_class(records)
    return page(
        "Grades",
        tag("header", banner(records), tag("h1", "Grades"), facts(records)),
        tag(
            "main",
            distribution(records),
            explain_again(records),
            everybody(records),
            gallery(records),
        )
        if records
        else tag("main", tag("p", "No submissions.")),
    )
