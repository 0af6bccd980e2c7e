"""history.py - who is in the class of an OUT, and how their marks have changed: history.csv, a line for each change.

Only this file writes them, when the reports of the class are written. The list of the class lets one person be marked
again without the submissions of the others.
"""
from __future__ import annotations

import csv
import io
import json
import time
from pathlib import Path

from grade.report.formats import mark, table
from grade.report.files import put
from .sheets import as_meant

LIST, HISTORY = ".class.json", "history.csv"
HEADING = ["when", "submission", "from", "to", "of", "why"]


def members(out: Path) -> dict:
    """Folder -> what its mark was made of, when the reports were written last; {} if none were."""
    try:
        found = json.loads((out / LIST).read_text(encoding="utf-8"))
        return {str(folder): dict(one) for folder, one in found.items()}
    except (OSError, ValueError, TypeError, AttributeError):
        return {}


def made_of(record: dict) -> dict:
    return {part: record.get(part) for part in
            ("submission", "person", "score", "max", "computed", "penalty", "decided", "key", "files", "status")}


def why(before: dict | None, now: dict) -> str:
    """What has changed a mark, or would have."""
    if before is None:
        return "marked"
    if before["files"] != now["files"] or before["status"] != now["status"]:
        return "handed in again" if now["files"] and before["files"] else now["status"]
    if before["decided"] != now["decided"]:
        return "; ".join(words for words in now["decided"] if words not in before["decided"]) or "a decision was taken back"
    if before["key"] != now["key"]:
        return "the tests, the seed or the tools have changed"
    return "the policy has changed" if before["computed"] == now["computed"] else "judged again, or the policy has changed"


def lines_of(out: Path) -> list:
    """The history so far, without its heading, the oldest first."""
    try:
        text = (out / HISTORY).read_text(encoding="utf-8-sig")
    except OSError:
        return []
    return [[as_meant(cell) for cell in row] for row in csv.reader(io.StringIO(text, newline=""))][1:]


def remember(records: list, out: Path) -> list:
    """Adds what has changed, and the list of the class. All lines, the oldest first."""
    before, rows = members(out), lines_of(out)
    now = {record["folder"]: made_of(record) for record in records}
    today = time.strftime("%Y-%m-%d %H:%M:%S")
    for folder, one in sorted(now.items()):
        old = before.get(folder)
        if old is not None and (old["score"], old["max"]) == (one["score"], one["max"]):
            continue
        rows.append([today, one["submission"], mark(old["score"]) if old else "", mark(one["score"]), mark(one["max"]),
                     why(old, one)])
    put(str(out), HISTORY, table([HEADING, *rows]))
    put(str(out), LIST, json.dumps(now, indent=0))
    return rows
