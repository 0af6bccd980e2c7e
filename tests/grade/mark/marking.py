"""marking.py - one submission from its files to its record.

Four steps: compile; link with what asks for answers; judge; and if a function failed that calls an
earlier one that failed, judge it again with the reference lent for that other one. What a student made
is run and compiled, but never read, save the compiler's words. A step that does not come to its end
raises GraderFailed (confine/machine.py).
"""
from __future__ import annotations

import re
import shutil
from pathlib import Path

from grade.confine.machine import GraderFailed
from grade.exercises import stems as chapters
from grade.policy import rounded

from .building import build
from .commands import REFUSED
from .workbench import Workbench

ESCAPES = {"n": "\n", "t": "\t", "\\": "\\"}  # of tests/judge/report.c

# ---- what the judge found ------------------------------------------------------------------------

def read_report(path: Path, names: list[str]) -> dict[str, dict[str, str]]:
    """FUNCTION -> KEY -> value (tests/judge/report.h). All of these functions, or it is no report."""
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


# ---- who waits -----------------------------------------------------------------------------------

def is_attempt(found: dict[str, str]) -> bool:
    """Wrong, and in a way that the tests know by name: it does its own work. Anything else may be a placeholder."""
    return found["state"] == "wrong" and "mistake" in found and found.get("partly") != "yes"


def calls_of(bench: Workbench, exercises: list) -> dict[str, set[str]]:
    """FUNCTION -> those of its chapter that it calls. Of the answers that were marked last: the reference's."""
    found: dict[str, set[str]] = {}
    for stem in chapters(exercises):
        write_lines(bench, f"{stem}.states", [[exercise.name, "any"] for exercise in exercises if exercise.stem == stem])
        found.update((name, set(others)) for name, others in calls(bench, stem, "any").items())
    return found


def calls(bench: Workbench, stem: str, states: str, may: bool = False) -> dict[str, list[str]]:
    """FUNCTION -> those that it calls, of the functions in STEM.states with one of these states (calls.awk)."""
    commands = [bench.kit.relocations(stem), bench.kit.calls(stem, states, may)]
    if bench.link(commands)["relocations"] in REFUSED:
        bench.link(commands)
        bench.check_room()
    (bench.folder / f"{stem}.relocations").unlink()
    lines = (bench.folder / f"{stem}.calls").read_text().splitlines()
    return {name: others for name, *others in map(str.split, lines)}


def write_lines(bench: Workbench, name: str, lines: list[list[str]]) -> None:
    (bench.folder / name).write_text("".join(" ".join(line) + "\n" for line in lines))


def may_wait(functions: dict[str, dict], called: dict[str, set[str]]) -> dict[str, list[str]]:
    """FUNCTION -> those that it may wait for. called: by the reference."""
    failed = [name for name, found in functions.items() if found["state"] in ("wrong", "waiting")]
    return {name: [other for j, other in enumerate(failed) if j < i or other in called.get(name, ())]
            for i, name in enumerate(failed)}


def lend(bench: Workbench, stem: str, functions: dict[str, dict], may: dict[str, list[str]]) -> dict[str, list[str]]:
    """FUNCTION -> those that it asked for, of the functions that pass if those that it may wait for are lent."""
    if not any(may.values()):
        return {}
    write_lines(bench, f"{stem}.states", [[name, found["state"]] for name, found in functions.items()])
    write_lines(bench, f"{stem}.may", [[name, *others] for name, others in may.items()])
    called = calls(bench, stem, "wrong waiting", may=True)
    if not called:
        return {}
    commands = [bench.kit.link_lent(stem, name, others) for name, others in called.items()]
    programs = bench.link(commands)
    if any(status in REFUSED for status in programs.values()):
        programs = bench.link(commands)
        bench.check_room()
    ready = [name for name, status in programs.items() if status == 0]
    judged = bench.judge([bench.kit.judge_lent(stem, name, called[name]) for name in ready]) if ready else {}
    for name in ready:
        (bench.folder / f"{stem}.{name}.exe").unlink()
    return {name: (bench.folder / f"{name}.asked").read_text().split() for name, status in judged.items() if status == 0}


def waiting(functions: dict[str, dict], asked: dict[str, list[str]]) -> dict[str, list[str]]:
    """Those that have their marks though they fail: see 'Waiting' in README.md. Two that wait for each other have
    none: neither is an answer."""
    good: dict[str, list[str]] = {}
    while True:
        more = {name: others for name, others in asked.items() if name not in good and others and
                all(other in good or is_attempt(functions[other]) for other in others)}
        if not more:
            return good
        good.update(more)


def draw(bench: Workbench, answered: list[str]) -> bool:
    """Whether yours.png is there: what the answers draw together, and right ones where there are none."""
    if bench.link([bench.kit.link_all([f"{stem}.o" for stem in answered])])["all"] != 0:
        return False
    return bench.judge([bench.kit.draw(answered)])["all"] == 0


# ---- the record ----------------------------------------------------------------------------------

def function_part(exercise, found: dict[str, str], waits_for: list[str] | None) -> dict:
    """One function's part of the record, but for its marks."""
    part = {"name": exercise.name, "slide": exercise.slide, "prompt": exercise.prompt,
            "state": found["state"], "test": found.get("test", "").replace("_", " "),
            "hidden": found.get("hidden") == "yes", "given": [], "expected": "", "yours": "",
            "how": found.get("how", ""), "waiting_for": [], "mistake": None,
            "partly": found.get("partly") == "yes", "law": ""}
    if waits_for:
        part.update(state="waiting", waiting_for=waits_for, partly=False)
        return part
    if part["state"] == "waiting":
        part.update(state="wrong", how=f"calls {found['missing']}, which is not answered yet")
    if "mistake" in found:
        part["mistake"] = {key: found.get(key, "") for key in ("formula", "why", "picture")}
        part["mistake"]["id"] = found["mistake"]
        if "also why" in found:
            part["mistake"]["also"] = {key: found.get(f"also {key}", "") for key in ("formula", "why")}
    if not part["hidden"]:
        part.update({key: found.get(key, "").replace("~", " ") for key in ("expected", "yours", "law")})
        part["given"] = [line.replace("~", " ").split("\t", 1)
                         for line in found.get("given", "").splitlines() if "\t" in line]
    return part


def stem_parts(bench: Workbench, answers: dict, exercises: list, called: dict) -> tuple[list[dict], bool]:
    """Each stem's part of the record, but for its marks; and whether there is a picture."""
    linked, trouble = build(bench, answers)
    names = {stem: [exercise.name for exercise in exercises if exercise.stem == stem] for stem in linked}
    if linked:
        bench.judge([bench.kit.judge(stem) for stem in linked])
    reports, waits = {}, {}
    for stem in linked:
        found = read_report(bench.folder / f"{stem}.d" / "report", names[stem])
        reports[stem] = {name: found[name] for name in names[stem]}
        (bench.folder / f"{stem}.exe").unlink()
    for stem in linked:
        waits[stem] = waiting(reports[stem], lend(bench, stem, reports[stem], may_wait(reports[stem], called)))

    parts = []
    for stem, answer in answers.items():
        state, words = trouble.get(stem, ("judged" if stem in linked else answer.state, answer.words))
        if state == "unreadable":
            state = "not judged"
        functions = []
        if state == "judged":
            functions = [function_part(exercise, reports[stem][exercise.name],
                                       waits[stem].get(exercise.name))
                         for exercise in exercises if exercise.stem == stem]
        parts.append({"stem": stem, "file": answer.file, "state": state, "words": words,
                      "functions": functions})
    right = all(part["functions"] and all(function["state"] == "right" for function in part["functions"])
                for part in parts)
    return parts, bool(linked) and not right and draw(bench, linked)


def add_marks(stem: dict, exercises: list, points, waiting_earns: bool) -> None:
    """points(stem, function): how many a function is worth. All that depends on the policy."""
    earns = {"right", "waiting"} if waiting_earns else {"right"}
    stem["max"] = rounded(sum(points(stem["stem"], exercise.name)
                              for exercise in exercises if exercise.stem == stem["stem"]))
    for function in stem["functions"]:
        function["max"] = points(stem["stem"], function["name"])
        function["score"] = function["max"] if function["state"] in earns else 0
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


def mark(bench: Workbench, collected, exercises: list, called: dict[str, set[str]]) -> dict:
    """The record, but for names and marks. called: which functions call which in the reference."""
    shutil.rmtree(bench.folder, ignore_errors=True)
    bench.folder.mkdir(parents=True)
    stems, is_drawn = stem_parts(bench, collected.answers, exercises, called)
    status, words = ("empty", collected.words) if collected.empty else status_of(stems)
    return {"status": status, "words": words or collected.words, "stems": stems,
            "pictures": {"expected": "expected.png", "yours": "yours.png"} if is_drawn else {},
            "seed": bench.seed, "sandbox": bench.sandbox.name, "unsafe": bench.sandbox.unsafe}
