"""marking.py - one submission from its files to its record.

Four steps: compile; link with what asks for answers; judge; and where a function failed that calls
another one that is not right, judge it again with the reference lent for that other one. What a student
made is run and compiled, but never read, save the compiler's words.
"""
from __future__ import annotations

import re
import shutil
from pathlib import Path

from building import build
from policy import rounded
from workbench import DRAW, JUDGE, JUDGE_LENT, LEND, LINK_ALL, Workbench

ESCAPES = {"n": "\n", "t": "\t", "\\": "\\"}  # of tests/judge/report.c

# ---- what the judge found ------------------------------------------------------------------------

def read_report(path: Path) -> dict[str, dict[str, str]]:
    """FUNCTION -> KEY -> value (tests/judge/report.h)."""
    functions: dict[str, dict[str, str]] = {}
    current: dict[str, str] = {}
    try:
        text = path.read_text(encoding="ascii")
    except (OSError, UnicodeDecodeError):
        return {}
    for line in text.splitlines():
        key, _, value = line.partition("\t")
        if key == "function":
            current = functions.setdefault(value, {})
        else:
            current[key] = re.sub(r"\\([nt\\])", lambda m: ESCAPES[m[1]], value)
    return functions


def lend(bench: Workbench, reports: dict[str, dict]) -> dict[str, dict[str, list[str]]]:
    """STEM -> FUNCTION -> those of its stem that it asked for, when it passed with them lent."""
    stems = []
    for stem, functions in reports.items():
        states = [function.get("state") for function in functions.values()
                  if function.get("state") != "right"]
        if len(states) > 1 and set(states) - {"unanswered"}:
            stems.append(stem)
    if not stems or not bench.link(LEND, stems):
        return {}
    bench.judge(JUDGE_LENT, stems)
    passed: dict[str, dict[str, list[str]]] = {}
    for stem in stems:
        for name in reports[stem]:
            if (bench.folder / f"{stem}.{name}.passed").exists():
                asked = (bench.folder / f"{stem}.{name}.asked").read_text().split()
                passed.setdefault(stem, {})[name] = asked
    return passed


def waiting(asked: dict[str, list[str]]) -> dict[str, list[str]]:
    """Those that are right but for others. Two that wait for each other are not: neither is an answer."""
    good: dict[str, list[str]] = {}
    while True:
        more = {name: others for name, others in asked.items() if name not in good and
                all(other not in asked or other in good for other in others)}
        if not more:
            return good
        good.update(more)


def draw(bench: Workbench, answered: list[str]) -> bool:
    """Whether yours.png is there: what the answers draw together, and right ones where there are none."""
    return bench.link(LINK_ALL, [f"{stem}.o" for stem in answered]) and bench.judge(DRAW, answered)


# ---- the record ----------------------------------------------------------------------------------

def function_part(exercise, found: dict[str, str], waits_for: list[str] | None) -> dict:
    """One function's part of the record, but for its marks."""
    part = {"name": exercise.name, "slide": exercise.slide, "prompt": exercise.prompt,
            "state": found.get("state", "timed out"), "test": found.get("test", "").replace("_", " "),
            "hidden": found.get("hidden") == "yes", "given": [], "expected": "", "yours": "",
            "how": found.get("how", ""), "waiting_for": [], "mistake": None,
            "partly": found.get("partly") == "yes", "law": ""}
    if not found:
        part["how"] = "was not judged: the whole chapter took too long"
    if waits_for:
        part.update(state="waiting", waiting_for=waits_for, partly=False)
        return part
    if part["state"] == "waiting":
        part.update(state="wrong", how=f"calls {found['missing']}, which is not answered; "
                                       "with the right answer in its place it does not pass, either")
    if "mistake" in found:
        part["mistake"] = {key: found.get(key, "") for key in ("formula", "why", "picture")}
        part["mistake"]["id"] = found["mistake"]
    if not part["hidden"]:
        part.update({key: found.get(key, "").replace("~", " ") for key in ("expected", "yours", "law")})
        part["given"] = [line.replace("~", " ").split("\t", 1)
                         for line in found.get("given", "").splitlines() if "\t" in line]
    return part


def stem_parts(bench: Workbench, answers: dict, exercises: list) -> tuple[list[dict], bool]:
    """Each stem's part of the record, but for its marks; and whether there is a picture."""
    linked, trouble = build(bench, answers)
    if linked:
        bench.judge(JUDGE, linked)
    reports = {stem: read_report(bench.folder / f"{stem}.d" / "report") for stem in linked}
    passed = {stem: waiting(asked) for stem, asked in lend(bench, reports).items()}

    parts = []
    for stem, answer in answers.items():
        state, words = trouble.get(stem, ("judged" if stem in linked else answer.state, answer.words))
        if state == "unreadable":
            state = "not judged"
        functions = []
        if state == "judged":
            functions = [function_part(exercise, reports[stem].get(exercise.name, {}),
                                       passed.get(stem, {}).get(exercise.name))
                         for exercise in exercises if exercise.stem == stem]
        parts.append({"stem": stem, "file": answer.file, "state": state, "words": words,
                      "functions": functions})
    right = all(part["functions"] and all(function["state"] == "right" for function in part["functions"])
                for part in parts)
    return parts, bool(linked) and not right and draw(bench, linked)


def add_marks(stem: dict, exercises: list, points) -> None:
    """points(stem, function): how many a function is worth. All that depends on the policy."""
    stem["max"] = rounded(sum(points(stem["stem"], exercise.name)
                              for exercise in exercises if exercise.stem == stem["stem"]))
    for function in stem["functions"]:
        function["max"] = points(stem["stem"], function["name"])
        function["score"] = function["max"] if function["state"] in ("right", "waiting") else 0
    stem["score"] = rounded(sum(function["score"] for function in stem["functions"]))


def status_of(stems: list[dict]) -> tuple[str, str]:
    """The gravest thing that happened, and where."""
    for stem in stems:
        if stem["state"] in ("does not compile", "cannot be linked"):
            return "does not compile", f"{stem['stem']} {stem['state']}"
    for state in ("timed out", "crashed"):
        for stem in stems:
            for function in stem["functions"]:
                if function["state"] == state:
                    return state, f"{stem['stem']}: {function['name']} {function['how']}"
    for stem in stems:
        if stem["state"] in ("twice", "not judged"):
            return "graded", f"{stem['stem']}: {stem['words']}"
    return "graded", ""


def mark(bench: Workbench, collected, exercises: list) -> dict:
    """The record, but for names and marks."""
    shutil.rmtree(bench.folder, ignore_errors=True)
    bench.folder.mkdir(parents=True)
    stems, is_drawn = stem_parts(bench, collected.answers, exercises)
    status, words = ("empty", collected.words) if collected.empty else status_of(stems)
    return {"status": status, "words": words or collected.words, "stems": stems,
            "pictures": {"expected": "expected.png", "yours": "yours.png"} if is_drawn else {},
            "seed": bench.seed, "sandbox": bench.sandbox.name, "unsafe": bench.sandbox.unsafe}
