"""reports.py - what must hold of the reports on a hostile class, whatever was handed in.

Each function gives the complaints: an empty list where all is well.
"""
from __future__ import annotations

import csv
import io
import json
import re
import xml.etree.ElementTree as xml
from pathlib import Path

from grade.report.files import ANSWERS
from .cases import STATUSES, Expected

PAID = {"right", "waiting"}
# A submission returns this if it could do something forbidden.
TELL = re.compile(r"\(7777, [^)]*\)")
ACTS = re.compile(rb"[\x00-\x08\x0b-\x0c\x0e-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\xaa-\xae]")
CLASSMATE_S = "a classmate's file"   # a secret
TIMES = {"seconds", "execution_time", "steps"}
MOST_SECONDS = 900  # for one submission, whatever it does, and however busy the machine is


def results(out: Path) -> list:
    """All results.json that can be read, in one list."""
    found = []
    for path in sorted(out.glob("*/results.json")):
        try:
            found.append(json.loads(path.read_text(encoding="utf-8")))
            record_of(found[-1])
        except (ValueError, KeyError, OSError):
            pass  # it is missed where results are counted
    return found


def record_of(result: dict) -> dict:
    return result["extra_data"]["record"]


def without_times(value):
    if isinstance(value, dict):
        return {key: without_times(part) for key, part in value.items() if key not in TIMES}
    return [without_times(part) for part in value] if isinstance(value, list) else value


def first_difference(a, b, where: str = "") -> str:
    if isinstance(a, dict) and isinstance(b, dict) and a.keys() == b.keys():
        return next(first_difference(a[key], b[key], f"{where}.{key}") for key in a if a[key] != b[key])
    if isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        return next(first_difference(x, y, f"{where}[{i}]") for i, (x, y) in enumerate(zip(a, b)) if x != y)
    return f"{where} is {a!r:.99} alone, {b!r:.99} among the others"


def strings(value):
    if isinstance(value, str):
        yield value
    elif isinstance(value, (dict, list)):
        for part in value.values() if isinstance(value, dict) else value:
            yield from strings(part)


def functions_of(record: dict) -> list:
    return [function for stem in record["stems"] for function in stem["functions"]]


def wrong_marks(record: dict, wanted: Expected) -> list:
    # A function that is worth nothing, as what is extra, is paid by its state.
    paid = {function["name"] for function in functions_of(record)
            if function["score"] > 0 or (function["max"] == 0 and function["state"] in PAID)}
    complaints = [f"{name}: earned nothing, expected its marks" for name in sorted(wanted.earns - paid)]
    complaints += [f"{name}: has marks that it did not earn" for name in sorted(paid - wanted.earns - wanted.perhaps)]
    for function in functions_of(record):
        whole = function["max"] if function["state"] in PAID else 0
        if abs(function["score"] - whole) > 1e-9:
            complaints.append(f"{function['name']}: {function['state']}, and {function['score']} of {function['max']}")
    if record["score"] is None:     # it cannot be read
        return complaints
    for what, parts in (("score", record["stems"]), ("max", record["stems"])):
        if abs(record[what] - sum(part[what] for part in parts)) > 0.02:
            complaints.append(f"{what} {record[what]} is not the sum of the chapters'")
    return complaints


def wordless(record: dict, wanted: Expected) -> list:
    """A verdict is words: why there are no marks, wherever there are none."""
    complaints = []
    if record["status"] != "graded" and not record["words"]:
        complaints.append(f"{record['status']}, and no words why")
    for stem in record["stems"]:
        if stem["state"] not in ("judged", "missing") and not stem["words"]:
            complaints.append(f"{stem['stem']}: {stem['state']}, and no words why")
    for function in functions_of(record):
        crashed = function["state"] in ("crashed", "timed out")
        why = ("how",) if crashed else ("how", "yours", "law", "mistake", "hidden")
        if function["state"] not in PAID | {"unanswered"} and not any(function[key] for key in why):
            complaints.append(f"{function['name']}: {function['state']}, and no words why")
    words = " ".join([record["words"], *(stem["words"] for stem in record["stems"]),
                      *(function["how"] for function in functions_of(record))])
    if wanted.says and not any(phrase in words for phrase in wanted.says):
        complaints.append(f"expected one of {wanted.says} in the words: {words[:300]}")
    return complaints


def about(record: dict, wanted: Expected) -> list:
    """All that must hold of one submission's record."""
    if record["score"] is None and record["status"] != "cannot be read":
        return [f"{record['status']}: {record['words']}"]
    complaints = wrong_marks(record, wanted) + wordless(record, wanted)
    if record["status"] not in wanted.statuses:
        complaints.append(f"status {record['status']} ({record['words'][:200]}), expected {sorted(wanted.statuses)}")
    if record["seconds"] > MOST_SECONDS:
        complaints.append(f"took {record['seconds']} s, expected at most {MOST_SECONDS}")
    complaints += [f"it could do what it must not: {found[0]}"
                   for text in strings(record) for found in TELL.finditer(text)]
    return complaints


def forged(out: Path, count: int) -> list:
    """The class's reports are read as their readers do: as many entries as submissions, none of them forged."""
    complaints = []
    rows = list(csv.reader(io.StringIO((out / "grades.csv").read_text(encoding="utf-8-sig"), newline="")))
    if len(rows) != count + 1:
        complaints.append(f"grades.csv: {len(rows) - 1} rows, expected {count}")
    complaints += [f"grades.csv: a cell begins with {cell[:9]!r}" for row in rows for cell in row
                   if cell[:1] in tuple("=+-@\t\r") and not re.fullmatch(r"-?[\d.]+", cell)]
    complaints += [f"grades.csv: status {row[1]!r}" for row in rows[1:] if row[1] not in STATUSES]
    names = tuple(record_of(result)["submission"] for result in results(out))
    cases = [case.get("name", "") for case in xml.parse(out / "junit.xml").iter("testcase")]
    complaints += [f"junit.xml: a test case {case}" for case in cases if not case.startswith(names)]
    for page in out.rglob("*.html"):
        text = page.read_text(encoding="utf-8").lower()
        if re.search(r"<script>alert|<b>forged|</pre><script|<forged", text):
            complaints.append(f"{page.relative_to(out)}: what a student wrote is markup")
    return complaints


def leaked(out: Path, words: bytes, secrets: dict) -> list:
    """Secrets, and bytes that act on a terminal, in anything that was written or printed, but for what somebody handed in
    (which holds its own secret)."""
    complaints = []
    texts = [("the output", words)]
    texts += [(str(path.relative_to(out)), path.read_bytes()) for path in sorted(out.rglob("*"))
              if path.is_file() and path.parent != out / ANSWERS]
    for name, content in texts:
        # The classmate's object file may hold the classmate's secret, and no other one.
        complaints += [f"{name}: {what}" for what, secret in secrets.items() if secret.encode() in content
                       and not (what == CLASSMATE_S and name.endswith(".o"))]
        if not name.endswith((".png", ".o")) and ACTS.search(content):
            complaints.append(f"{name}: a byte that acts on a terminal")
    return complaints


def forged_lines(words: bytes) -> list:
    return [f"the output has a line of a student's: {line[:80]!r}"
            for line in words.decode("utf-8", "replace").splitlines() if line.lstrip().startswith(("forged-mark", "ok 1 - "))]
