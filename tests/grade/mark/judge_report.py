"""judge_report.py - reads what the judge found of one chapter: lines of KEY tab VALUE (tests/judge/report.h)."""
from __future__ import annotations

import re
from pathlib import Path

from grade.confine.machine import GraderFailed

ESCAPES = {"n": "\n", "t": "\t", "\\": "\\"}  # what is not printable stays an escape: \x1b


def read_report(path: Path, names: list[str]) -> dict[str, dict[str, str]]:
    """FUNCTION -> KEY -> value (tests/judge/report.h). A report without one of these functions is invalid."""
    functions: dict[str, dict[str, str]] = {}
    current: dict[str, str] = {}
    try:
        text = path.read_text(encoding="ascii")
    except (OSError, UnicodeDecodeError) as error:
        raise GraderFailed(f"the judge's report cannot be read: {error}") from None
    for line in text.splitlines():
        key, _, value = line.partition("\t")
        if key == "function":
            current = functions.setdefault(value, {})
        else:
            current[key] = re.sub(r"\\([nt\\])", lambda m: ESCAPES[m[1]], value)
    lacking = [name for name in names if not functions.get(name, {}).get("state")]
    if lacking:
        raise GraderFailed(f"the judge's report says nothing of {lacking[0]}")
    return functions
