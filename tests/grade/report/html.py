"""html.py - the page of one submission: its marks, and what to look at in each chapter.

One file that needs no network and no script; pictures are inside it.
"""
from grade.visible import number
from .comment import fields, stem_lines
from .points import clean
from .tree import banner, data_url, page, read_picture, tag


def of(part: dict) -> str:
    return "no score" if part["score"] is None else f"{number(part['score'])} of {number(part['max'])}"


def kind(state: str) -> str:
    """The state as a class of the stylesheet."""
    return state.replace(" ", "-")


def share(score: float, most: float) -> str:
    return "unasked" if not most else "full" if score >= most else "none" if score <= 0 else "some"


def marks(record: dict):
    rows = [
        tag(
            "tr",
            tag("td", tag("a", stem["stem"], href="#" + stem["stem"])),
            tag(
                "td",
                "counts nothing" if not stem["max"] else stem["state"] if stem["state"] != "judged" else "",
                class_="warn" if stem["state"] != "judged" else None,
            ),
            tag("td", of(stem), class_=share(stem["score"], stem["max"])),
        )
        for stem in record["stems"]
    ]
    return tag(
        "table",
        tag("caption", "Marks by chapter"),
        tag(
            "thead",
            tag(
                "tr",
                tag("th", "chapter", scope="col"),
                tag("th", scope="col", aria_label="state"),
                tag("th", "marks", scope="col"),
            ),
        ),
        tag("tbody", *rows),
    )


def told(stem: dict, function: dict):
    """A function that wants a look: what its comment says, field by field."""
    lines, rows = [], []
    for label, words in fields(stem["stem"], function):
        if not label:
            lines.append(
                tag("p", ("" if function["state"] == "waiting" else "Should hold: ") + words)
            )
        elif label == "try":
            rows += [tag("dt", label), tag("dd", tag("code", words))]
        else:
            numbers = not function["hidden"] and label not in (
                "looks like",
                "you'd see",
                "but",
                "it",
                "asked",
            )
            rows += [tag("dt", label), tag("dd", words, class_="value" if numbers else None)]
    return tag(
        "article",
        tag(
            "div",
            tag(
                "h3",
                tag("code", function["name"]),
                " ",
                tag("span", function["state"], class_=kind(function["state"])),
            ),
            tag("span", of(function), class_="marks"),
            class_="head",
        ),
        tag("p", "Slide: " + function["slide"], class_="quiet") if function["slide"] else None,
        *lines,
        tag("dl", *rows) if rows else None,
        class_="told " + kind(function["state"]),
    )


def chapter(stem: dict):
    inside = []
    if stem["file"]:
        inside.append(tag("p", "From ", tag("bdi", stem["file"]), class_="quiet"))
    if stem["state"] == "judged":
        right = [function for function in stem["functions"] if function["state"] == "right"]
        if right:
            listed = []
            for function in right:
                listed += [", " if listed else "", tag("code", function["name"])]
            inside.append(tag("p", tag("span", "right ", class_="right"), *listed))
        others = [one for one in stem["functions"] if one["state"] != "right"]
        # As the student's terminal shows them: wrong before unanswered.
        others.sort(key=lambda one: one["state"] in ("unanswered", "waiting"))
        inside += [told(stem, one) for one in others]
    else:
        first, *rest = stem_lines(stem)
        inside.append(
            tag(
                "p",
                first[:1].upper() + first[1:].rstrip(":") + ("." if not rest else ":"),
                class_="warn",
            )
        )
        if rest:
            inside.append(tag("pre", "\n".join(rest), tabindex="0", aria_label="the message"))
    return tag(
        "section",
        tag("h2", tag("span", stem["stem"]), tag("span", of(stem), class_="marks"), class_="head"),
        *inside,
        id=stem["stem"],
    )


def pictures(record: dict, folder: str):
    """Expected beside theirs; None where the submission drew none."""
    found = {
        which: read_picture(folder, record["pictures"].get(which, ""))
        for which in ("expected", "yours")
    }
    if not found["yours"]:
        return None
    figures = [
        tag(
            "figure",
            tag("img", src=data_url(png), alt=f"the picture, {which}"),
            tag("figcaption", which),
        )
        for which, png in found.items()
        if png
    ]
    return tag("section", tag("h2", "Your picture"), tag("div", *figures, class_="pair"))


def submission_page(record: dict, folder: str) -> str:
    """folder: where the pictures of the record lie."""
    record = clean(record)
    status = [tag("strong", record["status"]), f": {of(record)}"]
    return page(
        f"{record['submission']}: {of(record)}",
        tag(
            "header",
            banner([record]),
            tag("h1", tag("bdi", record["submission"])),
            tag("p", *status, class_="score"),
            tag("p", record["words"], class_="warn") if record["words"] else None,
            tag("p", record["late"], class_="warn") if record["late"] else None,
        ),
        tag(
            "main",
            marks(record) if record["stems"] else None,
            pictures(record, folder),
            *[chapter(stem) for stem in record["stems"]],
        ),
        tag(
            "footer",
            tag(
                "p",
                "The same verdicts come from ",
                tag("code", "make exercises"),
                " in your own copy; what was drawn at random here is not in it, so look for"
                " the idea, not for the numbers.",
                class_="quiet",
            ),
        ),
    )
