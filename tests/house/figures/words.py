"""words.py - each word that a figure shows is in chapters/words.txt, and can be another one there.

Each text of the file is replaced by one without English words. Then none is left: by right answers, of cameras, rays
and scenes that have words of their own, and of known mistakes.
"""
import os
import re
import tempfile
from pathlib import Path

from check import Checks
from figure import PROGRAMS, Figure
from mistaken import printed

NUMBERS = r"\{[^}]*\}|%[sd%]|\$[^$]*\$"  # and mathematics
SAID = "zzz"
MISTAKES = 20  # are tried, until one changes the figure
KEPT = {SAID, "nan", "cos", "ac", "st", "across", "up"}  # 4ac, t²; the name of an exercise: across_30_up_10
ODD = {"camera-frame": ["--eye 90,90,90"], "double-dwh": ["--distance 100"], "camera-forms": ["--width 1e-9"],
       "look-at": ["--right -1,0,0"], "pixel-grid": ["-s 600x400 --pixel 300,200"],
       "ray-sphere": ["-o -2,9,0", "-o 3,0.5,0", "-o -900,0.5,0", "-c 1,0,0"], "parabola": ["-o -2,9,0", "-o -20,0.5,0", "-o -900,0.5,0"],
       "geometric-roots": ["-o -2,9,0", "-o -2,1,0", "-o -900,0.5,0"],
       "world-object": ["-o -2,9,0", "-o -900,0.5,0", "-c 5,90,3", "-o -2,1,0"], "explain": ["--pixel 0,0", "chapters/06-ray-casting/three-spheres.nff"],
       "image-order": ["--pixel 0,0", "chapters/06-ray-casting/three-spheres.nff"], "object-order": ["--pixel 0,0", "chapters/06-ray-casting/three-spheres.nff"],
       "ray-casting": ["--pixel 0,0", "chapters/06-ray-casting/three-spheres.nff"], "nearest-hit": ["--pixel 0,0 chapters/06-ray-casting/three-spheres.nff", "chapters/06-ray-casting/three-spheres.nff"],
       "beam-and-lobe": ["--light 1,-1,0"], "shadow-and-mirror": ["--light 9,9,0", "--eye 9,0.5,0"], "tangents": ["--center 0,0,9"]}


def blanks_of(file):
    """The texts of chapters/words.txt, each with what is said instead."""
    texts = [line for line in Path("chapters/words.txt").read_text(encoding="utf-8").splitlines() if line and line[0] != "#"]
    for text in texts:
        parts = re.split(f"({NUMBERS})", text)
        said = "".join(part if i % 2 else re.sub("[A-Za-z]{2,}", lambda word: word[0] if word[0] in KEPT else SAID, part)
                       for i, part in enumerate(parts))
        file.write(f"{text}\n  {said}\n")
    return texts


def english(figure):
    """The English words of a figure: those that are seen, and those that are read aloud. Not AB, a sphere."""
    seen = " ".join([text.words for text in figure.texts()] + list(figure.in_words()))
    return sorted(set(re.findall(r"\b(?![A-Z]+\b)[A-Za-z]{2,}", seen)) - KEPT)


def main():
    checks = Checks("words of figures")
    layouts = sorted(Path("chapters").glob("0*/figures/*.gp"))
    with tempfile.NamedTemporaryFile("w", encoding="utf-8", suffix=".txt") as file:
        texts = blanks_of(file)
        file.flush()
        os.environ["FIGURE_WORDS"] = file.name
        for layout in layouts:
            program, name = layout.parts[1], layout.stem
            for options in ["", *ODD.get(name, [])]:
                figure = Figure(program, name, *options.split())
                found = english(figure)
                checks.that(f"{name} {options}: all its words are in chapters/words.txt", not found, " ".join(found))
                checks.that(f"{name} {options}: it has words", SAID in "".join(figure.in_words()))
            if name != "flat-and-shaded":  # it takes seconds
                wrong = yours(program, name)
                found = english(wrong) if wrong else []
                checks.that(f"{name}: so are those about a mistake", not found, " ".join(found))
    # And the file has no text that no source says any more.
    sources = "\n".join(path.read_text(encoding="utf-8").replace("\\\n", "") for pattern in (
        "chapters/*/figures/*.*[cp]", "chapters/animations/*.gp", "common/figure/*.*") for path in Path().glob(pattern))
    known = set(re.findall(r"\w+", sources))
    for text in texts:
        strange = set(re.findall(r"\w+", text)) - known
        checks.that(f"a figure says {text!r}", not strange, " ".join(strange))
    checks.end()


def yours(program, name):
    """The figure by a known mistake that changes it, beside the right one; None if there is none."""
    mistaken = os.path.join(os.environ.get("BUILD", "build"), "tests/mistaken", program)
    with tempfile.NamedTemporaryFile("w", encoding="utf-8") as right:
        words = os.environ.pop("FIGURE_WORDS")  # what is right is compared in English
        right.write(printed(mistaken, -1, "--figure", name))
        os.environ["FIGURE_WORDS"] = words
        right.flush()
        called = printed(mistaken, -1, "--figure", name, "--answers").split()
        mistakes = [line.split("\t") for line in printed(mistaken, "list").splitlines()]
        for i in [i for i, (_, exercise, *_) in enumerate(mistakes) if exercise in called][:MISTAKES]:
            script = printed(mistaken, i, "--figure", name, "--beside", right.name)
            if "\nwrong = 1\n" in script:
                return Figure(None, name, script=script)
    return None


main()
