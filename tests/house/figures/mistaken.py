"""mistaken.py - figures of known mistakes (tests/proof/mistaken_figures.c): gnuplot draws each without a word; no text is
off its canvas; the mistake is named below; and all that is right is on the canvas, however wrong the rest is.

A line is a script, a tab, and whose mistake it is. In both shapes if all of them are tried (MISTAKES=1).
"""
import multiprocessing
import os
import sys

from check import Checks
from collisions import Marks, off_the_canvas
from figure import Figure

SHAPES = ("16:9", "4:3") if os.environ.get("MISTAKES") == "1" else ("16:9",)


class NoMarks:
    lines = ()


def found_in(line):
    path, mistake = line.rstrip("\n").split("\t")
    with open(path, encoding="utf-8") as file:
        script = file.read()
    name = os.path.basename(path).rsplit("-", 1)[0]
    found = []
    for shape in SHAPES:
        try:
            figure = Figure(None, name, script=script, settings=f"shape='{shape}'")
            right = Figure(None, name, script=script.replace("\nwrong = 1\n", "\nwrong = 0\n", 1),
                           settings=f"shape='{shape}'")
        except AssertionError as error:
            return f"{name}, {mistake}", [str(error)]
        texts = [text for text in figure.texts() if text.words]
        found += off_the_canvas(figure, texts, NoMarks)
        found += [f"right: {words}" for words in off_the_canvas(right, [], Marks(right))]
        if "\nwrong = 1\n" in script and not any(mistake.split()[0] in text.words for text in texts):
            found.append("the mistake is not named")
    return f"{name}, {mistake}", found


def main():
    checks = Checks("figures of known mistakes")
    with multiprocessing.Pool() as pool:
        for what, found in pool.imap(found_in, sys.stdin, chunksize=4):
            checks.that(what, not found, "\n    ".join(found))
    checks.end()


if __name__ == "__main__":
    main()
