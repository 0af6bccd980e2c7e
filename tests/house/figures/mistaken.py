"""mistaken.py - the deck's figures with known mistakes in the place of right answers (tests/proof/mistaken_figures.c):
gnuplot draws each without a word; no text is off its canvas; the mistake is named below; and all that is right is on
the canvas, however wrong the rest is.

MISTAKES says which are tried: every 100th, in one shape; 1 is all of them, in both.
"""
import multiprocessing
import os
import subprocess
import tempfile
from pathlib import Path

from check import SHAPES, Checks, Marks, lines_off, texts_off
from figure import Figure

EVERY = int(os.environ.get("MISTAKES") or 100)


def printed(*command):
    """What a program prints; nothing if it fails, as it may by wrong answers."""
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False, timeout=600)
    return done.stdout if done.returncode == 0 else ""


def scripts(folder):
    """(figure, its script, whose mistake it is), once for mistakes that look the same."""
    # Each figure begins with another mistake. The shaded picture takes seconds, so few of them are cast.
    for number, layout in enumerate(sorted(Path("chapters").glob("0[1-7]-*/figures/*.gp"))):
        program, name, every = layout.parts[1], layout.stem, EVERY
        if name == "flat-and-shaded":
            if EVERY > 1:
                continue
            every = 100
        mistaken = os.path.join(os.environ.get("BUILD", "build"), "tests/mistaken", program)
        figure, right = ("--figure", name), os.path.join(folder, name)
        Path(right).write_text(printed(mistaken, -1, *figure), encoding="utf-8")
        mistakes = [line.split("\t") for line in printed(mistaken, "list").splitlines()]
        called = printed(mistaken, -1, *figure, "--answers").split()
        stems = {stem for stem, exercise, *_ in mistakes if exercise in called}
        seen = set()
        for i in [i for i, (stem, *_) in enumerate(mistakes) if stem in stems][7 * number % every::every]:
            _, exercise, mistake, formula, why, _ = mistakes[i]
            command = (mistaken, i, *figure, "--beside", right)
            script = printed(*command)
            if script and script not in seen:
                seen.add(script)
                yield name, printed(*command, "--note", f"{exercise} looks like {formula}: {why}"), f"{exercise} {mistake}"


def found_in(job):
    name, script, mistake = job
    found = []
    for shape in SHAPES if EVERY == 1 else SHAPES[1:]:
        try:
            figure, right = (Figure(None, name, script=text, settings=f"shape='{shape}'")
                             for text in (script, script.replace("\nwrong = 1\n", "\nwrong = 0\n", 1)))
        except AssertionError as error:
            return f"{name}, {mistake}", [str(error)]
        found += texts_off(figure)
        found += [f"right: {words}" for words in lines_off(right, Marks(right))]
        if "\nwrong = 1\n" in script and not any(mistake.split()[0] in text.words for text in figure.texts()):
            found.append("the mistake is not named")
    return f"{name}, {mistake}", found


def main():
    checks = Checks("figures of known mistakes")
    with tempfile.TemporaryDirectory() as folder, multiprocessing.Pool() as pool:
        for what, found in pool.imap(found_in, scripts(folder), chunksize=4):
            checks.that(what, not found, "\n    ".join(found))
    checks.that("there are some", checks.passed > 20)
    checks.end()


if __name__ == "__main__":
    main()
