"""exercises.py - every exercise, once, in the order of the course: asks build/list_exercises."""
from __future__ import annotations

import subprocess
from dataclasses import dataclass
from pathlib import Path

LIST = Path(__file__).resolve().parent.parent.parent / "build/list_exercises"


@dataclass(frozen=True)
class Exercise:
    stem: str       # 05-quadratic
    name: str       # hit_sphere
    prototype: str  # double hit_sphere(Ray ray, Sphere sphere)
    slide: str
    prompt: str     # what the slide asks


def read(program=LIST) -> list:
    words = subprocess.run([program], check=True, capture_output=True, encoding="utf-8").stdout
    return [Exercise(*line.split("\t")) for line in words.splitlines()]


def stems(exercises) -> list:
    """Each once, in order."""
    return list(dict.fromkeys(exercise.stem for exercise in exercises))


def prototypes(exercises) -> dict[str, dict[str, str]]:
    """stem -> function -> prototype"""
    return {stem: {exercise.name: exercise.prototype for exercise in exercises if exercise.stem == stem}
            for stem in stems(exercises)}
