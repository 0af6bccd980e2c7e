"""formats.py - the reports that programs read: grades.csv, junit.xml, and Gradescope's results.json."""
import csv
import io
import json
import re
import xml.etree.ElementTree as ElementTree

from grade.collect.answers import UNREADABLE
from grade.visible import number, score
from .figures import stems_of
from .points import UNSAFE, any_unsafe, clean, clean_class, points, reason

# ---- grades.csv ---------------------------------------------------------------------------------


RUNS = "=+-@\t\r\n" + "＝＋－＠"  # a Japanese Excel also takes the wide ones for signs
MARK = "\ufeff"
PLAIN = re.compile(r"[\w ./:-]*", re.ASCII)
MARKS = re.compile(r"-?\d+(\.\d+)?", re.ASCII)


def cell(text: str) -> str:
    """A number may have a sign."""
    if MARKS.fullmatch(text):
        return text
    return "'" + text if text.lstrip(" ")[:1] and text.lstrip(" ")[0] in RUNS else text


def mark(score) -> str:
    """An empty cell: a grade book reads it as a missing score, not as 0."""
    return "" if score is None else number(score)


def table(rows: list) -> str:
    """RFC 4180, lines end in CRLF. UTF-8 with a byte order mark, without which Excel takes names with umlauts for another
    encoding. A spreadsheet runs a cell that begins with = + - or @, so such a cell begins with an apostrophe instead; and
    because some split at semicolons, whatever is more than letters, digits and a few signs is quoted."""
    out = io.StringIO(newline="")
    for row in rows:
        row = [cell(text) for text in row]
        plain = all(PLAIN.fullmatch(text) for text in row)
        csv.writer(out, lineterminator="\r\n", quoting=csv.QUOTE_MINIMAL if plain else csv.QUOTE_ALL).writerow(row)
    return MARK + out.getvalue()


SUM = ("computed", "penalty", "adjusted")    # what a final mark is the sum of


def grades_csv(records: list) -> str:
    """One row per submission, for the grade book: the chapters add up to 'computed', and computed, late and adjusted to
    'final'."""
    records = clean_class(records)
    stems = stems_of(records)
    known = [field for field in ("id", "login", "section") if any(record["person"].get(field) for record in records)]
    rows = [["submission", *known, "status", "final", "max", *stems, "computed", "late", "adjusted", "reason"]]
    for record in records:
        marks = {stem["stem"]: stem["score"] for stem in record["stems"]}
        status = record["status"] + (" (UNSAFE: no sandbox)" if record["unsafe"] else "")
        none = None if record["computed"] is None else 0
        rows.append([record["submission"], *(record["person"].get(field, "") for field in known), status,
                     mark(record["score"]), number(record["max"]), *(mark(marks.get(stem, none)) for stem in stems),
                     *(mark(record[part]) for part in SUM), reason(record)])
    return table(rows)


# ---- junit.xml ----------------------------------------------------------------------------------


def comment_text(point: dict) -> str:
    return "\n".join(point["lines"]) or point["message"]


def add_case(suite: ElementTree.Element, submission: str, point: dict, used: set) -> None:
    # Readers drop a second test of one name, so the submission is in it.
    name = f"{submission}: {point['name']}"
    while name in used:
        name += " again"
    used.add(name)
    case = ElementTree.SubElement(suite, "testcase", classname=f"{submission}.{point['stem'] or 'submission'}",
                                  name=name, time="0")
    if point["outcome"] == "skipped":
        ElementTree.SubElement(case, "skipped", message=point["message"])
    elif point["outcome"] != "passed":
        trouble = ElementTree.SubElement(case, point["outcome"], message=point["message"], type=point["state"])
        trouble.text = comment_text(point)


def counted(name: str, cases: list, seconds: float) -> dict:
    """The attributes of a suite."""
    outcomes = [point["outcome"] for point in cases]
    return {"name": name, "tests": str(len(outcomes)), "failures": str(outcomes.count("failure")),
            "errors": str(outcomes.count("error")), "skipped": str(outcomes.count("skipped")), "time": f"{seconds:.3f}"}


def junit_xml(records: list) -> bytes:
    """A wrong or unanswered function fails; a crash, an endless loop or a file that does not compile is an error; a
    file that was not handed in is skipped. The inputs and results are in the failure, never in <system-out>, because
    GitLab obeys tags that it finds there."""
    records = clean_class(records)
    told = [points(record) for record in records]
    root = ElementTree.Element("testsuites", counted(UNSAFE if any_unsafe(records) else "grades", sum(told, []),
                                                     sum(record["seconds"] for record in records)))
    used = set()
    for record, cases in zip(records, told):
        suite = ElementTree.SubElement(root, "testsuite", counted(record["submission"], cases, record["seconds"]))
        properties = ElementTree.SubElement(suite, "properties")
        for name, value in (("status", record["status"]), ("score", number(record["score"])),
                            ("max", number(record["max"])), ("seed", str(record["seed"])),
                            ("sandbox", UNSAFE if record["unsafe"] else record["sandbox"])):
            ElementTree.SubElement(properties, "property", name=name, value=value)
        for point in cases:
            add_case(suite, record["submission"], point, used)
    ElementTree.indent(root, " ")
    return ElementTree.tostring(root, encoding="utf-8", xml_declaration=True) + b"\n"


# ---- results.json -------------------------------------------------------------------------------


def summary(record: dict) -> str:
    """The text above all tests."""
    lines = [UNSAFE] if record["unsafe"] else []
    lines.append(f"{record['status']}: {score(record)}")
    lines += [line for line in (record["words"], record["late"], *record["decided"]) if line]
    if any(stem["functions"] for stem in record["stems"]):
        lines.append("'make exercises' says the same of your files, but for the random inputs of this run.")
    return "\n".join(lines)


def test(point: dict) -> dict:
    output = "\n".join(point["lines"])
    return {
        **({} if point["score"] is None else {"score": point["score"]}),
        "max_score": point["max"],
        "status": "passed" if point["outcome"] == "passed" else "failed",
        "name": point["name"],
        "number": point["number"],
        "output": output or ("right" if point["outcome"] == "passed" else point["message"]),
        "output_format": "text",
    }


def results_json(record: dict) -> str:
    """Same record, same bytes. All tests are visible: one hidden test would hide the student's total. The whole record
    lies in extra_data, and class reports are made from it."""
    record = clean(record)
    # Without a score and tests Gradescope says that the autograder failed, which is so, but not if the submission
    # cannot be read: then only a score shows the student the reason.
    earned = 0 if record["status"] == UNREADABLE else record["score"]
    marks = {"score": earned, "tests": [test(point) for point in points(record)]}
    results = {
        **(marks if earned is not None else {}),
        "execution_time": record["seconds"],
        "output": summary(record),
        "output_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "extra_data": {"record": record},
    }
    # No NaN: it is no JSON, and a mark that is none should stop here and not in a grade book.
    return json.dumps(results, ensure_ascii=True, allow_nan=False, indent=1) + "\n"
