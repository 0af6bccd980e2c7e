"""lecture_figures.py - for the next lecture: a figure of each mistake that is to be explained again, from a real wrong answer
beside the right one, without its author.

The answer is judged once more, in the sandbox, and the judge writes the figure as well (tests/judge/figure.h). A figure
that is there already is not drawn again.
"""
from __future__ import annotations

import hashlib
import shutil
import subprocess
import sys
from pathlib import Path

from grade.collect.answers import Answer
from grade.confine.machine import GraderFailed
from grade.report.figures import most_made
from grade.report.files import answers_of
from grade.visible import visible

from .building import build
from .grader import PACKAGE, Grader
from .workbench import Workbench

FIGURES = "figures"     # the folder in OUT
DRAW = [sys.executable, "-B", str(PACKAGE.parents[1] / "chapters/gallery/draw_figures.py"), "--one"]
MOST_TRIED = 3          # answers, for one figure: of some nothing can be drawn
SECONDS = 60


def script_of(grader: Grader, stem: str, function: str, text: str) -> Path | None:
    """The judge's: for gnuplot, or a PNG."""
    bench = Workbench(grader.kit, grader.sandbox, grader.work / "figure", grader.tables, grader.seed, grader.right)
    shutil.rmtree(bench.folder, ignore_errors=True)
    (bench.folder / FIGURES).mkdir(parents=True)
    ready, _ = build(bench, {stem: Answer("found", text=text.encode())})
    if not ready:
        return None
    bench.judge([grader.kit.judge(stem, figures=(FIGURES,))], grader.kit.layouts)
    made = [bench.folder / FIGURES / f"{function}{end}" for end in (".gp", ".png")]
    return next((path for path in made if path.exists()), None)


def drawn(grader: Grader, stem: str, function: str, text: str, name: str) -> str:
    """The name of the picture; '' if there is none."""
    script = script_of(grader, stem, function, text)
    if script is not None and script.suffix == ".gp":
        done = subprocess.run([*DRAW, script.parent, function], stdin=subprocess.DEVNULL, capture_output=True, timeout=SECONDS)
        script = script.with_suffix(".svg") if done.returncode == 0 else None
    if script is None or not script.exists():
        return ""
    shutil.copyfile(script, grader.out / FIGURES / f"{name}{script.suffix}")
    return f"{name}{script.suffix}"


def can_be_drawn(record: dict, stem: str, name: str) -> bool:
    """Not a crash or a loop, and not of hidden inputs."""
    return any(function["name"] == name and function["state"] == "wrong" and not function["hidden"]
               for one in record["stems"] if one["stem"] == stem for function in one["functions"])


def figure_of(grader: Grader, made: dict, there: dict[str, str]) -> str:
    """there: names without their ends, of the figures that are there."""
    stem, function = made["stem"], made["function"]
    who = [record for record in made["who"] if can_be_drawn(record, stem, function)]
    for record in sorted(who, key=lambda record: record["folder"])[:MOST_TRIED]:
        text = answers_of(str(grader.out), record["folder"]).get(stem)
        if text is None:
            continue
        depends = hashlib.sha256(f"{grader.circumstances()}\n{text}".encode()).hexdigest()
        name = f"{stem}-{function}-{depends[:8]}"
        if found := there.get(name) or drawn(grader, stem, function, text, name):
            return found
    return ""


def lecture_figures(grader: Grader, records: list) -> list[str]:
    """For each of most_made(records) the name of its figure in OUT/figures; '' if nothing can be drawn of it."""
    folder = grader.out / FIGURES
    folder.mkdir(exist_ok=True)
    there = {path.stem: path.name for path in folder.iterdir()}
    found = []
    for made in most_made(records):
        try:
            found.append(figure_of(grader, made, there))
        except (GraderFailed, OSError, subprocess.TimeoutExpired) as error:
            found.append("")
            print(f"No figure of {made['function']}: {visible(str(error))}", file=sys.stderr)
    for name in set(there.values()) - set(found):
        (folder / name).unlink()
    return found
