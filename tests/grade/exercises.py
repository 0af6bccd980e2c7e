"""exercises.py - reads tests/exercises.table: every exercise, once, in the order of the course."""
from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

TABLE = Path(__file__).resolve().parent.parent / "exercises.table"


@dataclass(frozen=True)
class Exercise:
    stem: str    # 05-quadratic
    name: str    # hit_sphere
    prototype: str
    slide: str
    prompt: str  # what the slide asks


def read(path=TABLE) -> list:
    exercises = []
    for number, line in enumerate(Path(path).read_text(encoding="utf-8").splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        cells = line.split(" | ")
        name = re.match(r"[^(]*?(\w+)\(", cells[1]) if len(cells) == 4 else None
        if not name:
            raise ValueError(f"{path}:{number}: no exercise, "
                             "expected stem | prototype | slide | what the slide asks")
        exercises.append(Exercise(*(cell.strip() for cell in (cells[0], name[1], *cells[1:]))))
    return exercises


def stems(exercises) -> list:
    """Each once, in order."""
    return list(dict.fromkeys(exercise.stem for exercise in exercises))
