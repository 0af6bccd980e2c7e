"""formats.py - the reports that programs read: grades.csv, and Gradescope's results.json."""
import csv
import io
import json
import re

from grade.collect.answers import PARTLY, UNREADABLE
from grade.visible import number, score
from .comment import function_lines, stem_lines
from .figures import stems_of
from .record import UNSAFE, clean, clean_class, reason

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


# ---- results.json -------------------------------------------------------------------------------


def summary(record: dict) -> str:
    """The text above all tests."""
    lines = [UNSAFE] if record["unsafe"] else []
    lines.append(f"{record['status']}: {score(record)}")
    lines += [line for line in (record["words"], record["late"], *record["decided"]) if line]
    if any(stem["functions"] for stem in record["stems"]):
        lines.append("'make exercises' says the same of your files, but for the random inputs of this run.")
    return "\n".join(lines)


def test(name: str, number: str, part: dict, passed: bool, says: str) -> dict:
    """part: what has marks; says: what the student reads of it."""
    return {**({} if part["score"] is None else {"score": part["score"]}), "max_score": part["max"],
            "status": "passed" if passed else "failed", "name": name, "number": number, "output": says, "output_format": "text"}


def function_test(stem: str, number: str, function: dict) -> dict:
    """A waiting function passes if the policy gives it its marks."""
    waits = function["state"] == "waiting"
    passed = function["state"] == "right" or (waits and bool(function["score"] or not function["max"]))
    return test(f"{stem}: {function['name']}", number, function, passed, "\n".join(function_lines(stem, function)) or "right")


def tests(record: dict) -> list:
    """One for each function of a stem that was judged, and for a stem that was not; one for a submission without stems, or
    that was not read to its end. So nothing that a student wrote adds one."""
    found = []
    for place, stem in enumerate(record["stems"], 1):
        name = stem["stem"]
        number = str(int(name[:2])) if name[:2].isdecimal() else f"x{place}"
        if stem["state"] == "judged":
            found += [function_test(name, f"{number}.{index}", function) for index, function in enumerate(stem["functions"], 1)]
        elif stem["state"] != "missing" or stem["max"]:     # else it was not asked for
            found.append(test(f"{name}: {stem['state']}", number, stem, False, "\n".join(stem_lines(stem))))
    if not found or record["status"] == PARTLY:
        whole = {"score": 0, "max": 0} if found else record
        found.insert(0, test(record["status"], "0", whole, False, record["words"] or record["status"]))
    return found


def results_json(record: dict) -> str:
    """Same record, same bytes. All tests are visible: one hidden test would hide the student's total. The whole record
    lies in extra_data, and class reports are made from it."""
    record = clean(record)
    # Without a score and tests Gradescope says that the autograder failed, which is so, but not if the submission
    # cannot be read: then only a score shows the student the reason.
    earned = 0 if record["status"] == UNREADABLE else record["score"]
    marks = {"score": earned, "tests": tests(record)}
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
