"""test_example.py - what the instructor's page says of the ten submissions is what 'make grade' says."""
from __future__ import annotations

import csv
import json
import os
import re
import subprocess
import tempfile
from pathlib import Path

from .fixtures import Sentences

HERE = Path("tests/grade")
ELSEWHERE = "make handout"      # by tests/house/handout.sh; two at a time would get into each other's way
PAGE, RECIPES, EXAMPLE = HERE / "README.md", HERE / "recipes", HERE / "example"


def blocks(page: str, kind: str) -> list[str]:
    """The page's ```text or ```console blocks."""
    return re.findall(rf"^```{kind}\n(.*?)^```", page, re.M | re.S)


def commands(page: str) -> list[tuple[str, str]]:
    """Of the console blocks: each command, and what the page says that it prints."""
    return [(command.replace("\\\n", ""), said) for block in blocks(page, "console")
            for command, said in re.findall(r"^\$ ((?:.*\\\n)*.*)\n((?:(?!\$ ).*\n)*)", block, re.M)]


def as_everywhere(words: str, out: str) -> str:
    """But for the sandbox of this machine, sizes, dates, how long it took, where it is, and what make built before."""
    words = words[max(words.find("submission    "), 0):].partition("\nTook ")[0].replace(out, "build/marks")
    for pattern, same in ((r"Sandbox: .*", "Sandbox: (any)"), (r"\d+ kB", "... kB"), (r"\d{4}-\d\d-\d\d( \d\d:\d\d:\d\d)?", "(date)")):
        words = re.sub(pattern, same, words)
    return words.strip()


def told(out: Path) -> set[str]:
    """Every line in the students' comments."""
    found = set()
    for path in out.glob("*/results.json"):
        results = json.loads(path.read_text(encoding="utf-8"))
        for words in [results["output"], *(test["output"] for test in results["tests"])]:
            found |= set(words.split("\n"))
    return found


class Example(Sentences):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.marks, cls.out = folder.name, Path(folder.name) / "week-1"
        cls.page = PAGE.read_text(encoding="utf-8")
        environment = {**os.environ, "MAKEFLAGS": "s --no-print-directory"}
        cls.said = [(command, wanted, subprocess.run(["sh", "-c", command.replace("build/marks", cls.marks)], env=environment,
                                                     stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8"))
                    for command, wanted in commands(cls.page) if command != ELSEWHERE]

    def test_the_page_quotes_what_its_commands_print(self):
        self.assertEqual(len(self.said), 8)
        for command, wanted, done in self.said:
            with self.subTest(command):
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(as_everywhere(wanted, self.marks), as_everywhere(done.stdout.lstrip("\ufeff"), self.marks))

    def test_the_page_quotes_what_students_are_told(self):
        quoted = blocks(self.page, "text")[0].splitlines()
        self.assertGreater(len(quoted), 1)
        self.assertEqual([line for line in quoted if line not in told(self.out)], [])

    def test_a_comment_with_a_dollar_is_what_was_typed(self):
        subprocess.run(["make", "-s", "grade-set", "WHO=waits", "WHAT=comment", "COMMENT=it costs $5", f"OUT={self.out}"], check=True,
                       stdout=subprocess.DEVNULL)
        self.assertIn("waits,,comment,,it costs $5,", (self.out / "ledger.csv").read_text(encoding="utf-8"))

    def test_the_marks_are_those_that_the_page_explains(self):
        explained = re.findall(r"^\| `([a-z-]*)` \| ([a-z ]*) \| ([0-9]*) \|", self.page, re.M)
        self.assertEqual(len(explained), 10)
        with open(self.out / "grades.csv", encoding="utf-8-sig", newline="") as file:
            rows = [(row["submission"], row["status"], row["computed"]) for row in csv.DictReader(file)]
        self.assertEqual(sorted(explained), sorted(rows))

    def test_what_is_explained_again_has_a_figure_for_the_lecture_without_its_author(self):
        [figure] = (self.out / "figures").iterdir()
        self.assertRegex(figure.name, r"^03-screen-pixel_center-[0-9a-f]{8}\.svg$")
        told = figure.read_text(encoding="utf-8")
        self.assertIn("expected: (0.5, 0.5)", told)
        self.assertNotIn("crash", told)
        self.assertIn(f'src="./figures/{figure.name}"', (self.out / "index.html").read_text(encoding="utf-8"))

    def test_deep_folder_still_has_its_windows_line_ends(self):
        [path] = Path("build/example-class").glob("deep-folder/*/*/01-corners.c")
        self.assertIn(b"\r\n", path.read_bytes())


class Recipes(Sentences):
    def test_their_page_speaks_of_each(self):
        page = (RECIPES / "README.md").read_text(encoding="utf-8")
        for recipe in [*RECIPES.glob("*.yml"), RECIPES / "Containerfile", *(RECIPES / "gradescope").iterdir()]:
            self.check(f"it speaks of {recipe.name}", f"]({recipe.relative_to(RECIPES)})" in page)
