"""gradebook.py - grades.csv: one row per submission, for the grade book.

RFC 4180, lines end in CRLF. UTF-8 with a byte order mark, without which Excel takes names with umlauts
for another encoding. A spreadsheet runs a cell that begins with = + - or @, so such a
cell begins with an apostrophe instead; and since some split at semicolons, whatever is more than
letters, digits and a few signs is quoted.
"""
import csv
import io
import re

from grade.visible import number
from .figures import stems_of
from .points import clean_class

RUNS = "=+-@\t\r\n" + "＝＋－＠"  # a Japanese Excel also takes the wide ones for signs
MARK = "\ufeff"
PLAIN = re.compile(r"[\w ./:-]*", re.ASCII)


def cell(text: str) -> str:
    return "'" + text if text.lstrip(" ")[:1] and text.lstrip(" ")[0] in RUNS else text


def mark(score) -> str:
    """An empty cell: a grade book reads it as a missing score, not as 0."""
    return "" if score is None else number(score)


def grades_csv(records: list) -> str:
    records = clean_class(records)
    stems = stems_of(records)
    rows = [["submission", "status", "score", "max"] + stems]
    for record in records:
        marks = {stem["stem"]: stem["score"] for stem in record["stems"]}
        status = record["status"] + (" (UNSAFE: no sandbox)" if record["unsafe"] else "")
        rows.append(
            [record["submission"], status, mark(record["score"]), number(record["max"])]
            + [mark(marks.get(stem, None if record["score"] is None else 0)) for stem in stems]
        )
    out = io.StringIO(newline="")
    for row in rows:
        row = [cell(text) for text in row]
        plain = all(PLAIN.fullmatch(text) for text in row)
        csv.writer(
            out, lineterminator="\r\n", quoting=csv.QUOTE_MINIMAL if plain else csv.QUOTE_ALL
        ).writerow(row)
    return MARK + out.getvalue()
