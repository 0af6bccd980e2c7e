"""marking.py - one submission from its files to its record.

Four steps: compile; link with the answering process; judge; and if a failed function calls an earlier
failed one, judge it again with the reference lent for that other one. The student's code is compiled
and run; the grader reads only the compiler's words and the judge's report. A step that
cannot finish raises GraderFailed (confine/machine.py).
"""
from __future__ import annotations

import copy
import shutil

from grade.confine.machine import check_processes
from grade.policy import rounded

from .building import build, is_refused, linked
from .judging import judged, lend, may_wait, waiting
from .verdicts import Verdict, Verdicts
from .workbench import Workbench


def draw(bench: Workbench, answered: list[str]) -> bool:
    """Whether yours.png is there: what the answers draw together, and right ones where there are none."""
    programs = linked(bench, {"all": bench.kit.link_all([f"{stem}.o" for stem in answered])},
                      lambda _: bench.kit.link_all([]))
    if is_refused(programs["all"]):
        return False
    return bench.judge([bench.kit.draw(answered)])["all"] == 0


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


def judged_now(bench: Workbench, answers: dict, exercises: list, called: dict) -> dict[str, Verdict]:
    """STEM -> the verdict, of those that were found. All steps are taken."""
    ready, trouble = build(bench, answers)
    reports = judged(bench, {stem: [exercise.name for exercise in exercises if exercise.stem == stem]
                             for stem in ready})
    for stem in ready:
        (bench.folder / f"{stem}.exe").unlink()
    waits = {stem: waiting(reports[stem], lend(bench, stem, reports[stem], may_wait(reports[stem], called)))
             for stem in ready}
    verdicts = {stem: Verdict(state, words, []) for stem, (state, words) in trouble.items()}
    for stem in ready:
        functions = [function_part(exercise, reports[stem][exercise.name], waits[stem].get(exercise.name))
                     for exercise in exercises if exercise.stem == stem]
        verdicts[stem] = Verdict("judged", "", functions, (bench.folder / f"{stem}.o").read_bytes())
    return verdicts


def stem_parts(bench: Workbench, answers: dict, exercises: list, called: dict,
               kept: Verdicts | None) -> tuple[list[dict], bool]:
    """Each stem's part of the record, but for its marks; and whether there is a picture."""
    there = {stem: answer for stem, answer in answers.items() if answer.state == "found"}
    known = {stem: verdict for stem, answer in there.items() if kept and (verdict := kept.find(stem, answer.text))}
    new = judged_now(bench, {stem: answer for stem, answer in there.items() if stem not in known}, exercises, called)
    for stem, verdict in known.items():
        if verdict.object:
            (bench.folder / f"{stem}.o").write_bytes(verdict.object)
    for stem, verdict in new.items() if kept else ():
        kept.keep(stem, there[stem].text, verdict)

    parts, drawn = [], []
    for stem, answer in answers.items():
        verdict = known.get(stem) or new.get(stem) or Verdict(answer.state, answer.words, [])
        drawn += [stem] * bool(verdict.object)
        parts.append({"stem": stem, "file": answer.file,
                      "state": "not judged" if verdict.state == "unreadable" else verdict.state,
                      "words": answer.words if verdict.state == "judged" else verdict.words,
                      "functions": copy.deepcopy(verdict.functions)})
    right = all(part["functions"] and all(function["state"] == "right" for function in part["functions"])
                for part in parts)
    return parts, bool(drawn) and not right and draw(bench, drawn)


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


def mark(bench: Workbench, collected, exercises: list, called: dict[str, set[str]], kept: Verdicts | None = None) -> dict:
    """The record, but for names and marks. called: which functions call which in the reference."""
    shutil.rmtree(bench.folder, ignore_errors=True)
    bench.folder.mkdir(parents=True)
    check_processes(bench.sandbox.confine)
    stems, is_drawn = stem_parts(bench, collected.answers, exercises, called, kept)
    status, words = (collected.status, collected.words) if collected.status else status_of(stems)
    return {"status": status, "words": words or collected.words, "stems": stems,
            "pictures": {"expected": "expected.png", "yours": "yours.png"} if is_drawn else {},
            "seed": bench.seed, "sandbox": bench.sandbox.name, "unsafe": bench.sandbox.unsafe}
