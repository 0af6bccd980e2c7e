"""test_example.py - what the instructor's page says of the ten submissions is what 'make grade' says."""
from __future__ import annotations

import csv
import json
import re
import subprocess
import tempfile
from pathlib import Path

from .fixtures import Sentences

HERE = Path("tests/grade")
PAGE, RECIPES, EXAMPLE = HERE / "README.md", HERE / "recipes", HERE / "example"


def blocks(page: str) -> list[str]:
    """The page's ```text blocks."""
    return re.findall(r"^```text\n(.*?)^```", page, re.M | re.S)


def as_everywhere(words: str) -> str:
    """But for the sandbox of this machine, how long it took, and what make built before."""
    words = words[words.index("submission "):].partition("\nTook ")[0]
    return re.sub(r"Sandbox: .*", "Sandbox: (any)", words).rstrip("\n")


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
        cls.out = Path(folder.name) / "out"
        cls.page = PAGE.read_text(encoding="utf-8")
        cls.done = subprocess.run(
            ["make", "-s", "--no-print-directory", "grade", "SUBMISSIONS=build/example-class", f"POLICY={EXAMPLE}/policy",
             f"OUT={cls.out}", "SEED=2015"], capture_output=True, encoding="utf-8")

    def test_make_grade_grades_it(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)

    def test_the_page_quotes_what_the_terminal_says(self):
        self.assertEqual(as_everywhere(blocks(self.page)[0]), as_everywhere(self.done.stdout))

    def test_the_page_quotes_what_students_are_told(self):
        quoted = blocks(self.page)[1].splitlines()
        self.assertGreater(len(quoted), 1)
        self.assertEqual([line for line in quoted if line not in told(self.out)], [])

    def test_the_marks_are_those_that_the_page_explains(self):
        explained = re.findall(r"^\| `([a-z-]*)` \| ([a-z ]*) \| ([0-9]*) \|", self.page, re.M)
        self.assertEqual(len(explained), 10)
        with open(self.out / "grades.csv", encoding="utf-8-sig", newline="") as file:
            rows = [(row["submission"], row["status"], row["final"]) for row in csv.DictReader(file)]
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
