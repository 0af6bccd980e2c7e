"""test_gradescope.py - the archive for Gradescope, in a folder that is laid out as it is there."""
from __future__ import annotations

import json
import os
import shutil
import subprocess
import time
import zipfile
from pathlib import Path

from .fixtures import Sentences

NO_MARK = "neither a score nor a test"
CLASS = Path("build/example-class")
ARCHIVE = Path("build/gradescope.zip")
# make's variables for its children would decide how the copy is built.
OF_MAKE = {"MAKEFLAGS", "CC", "ANSWERS", "SEED", "OUT", "POLICY", "UNSAFE", "SANDBOX"}


class Gradescope(Sentences):
    def setUp(self):
        super().setUp()
        self.toolkit = self.work / "source" / "toolkit"
        self.submission = self.work / "submission"
        self.environment = {name: value for name, value in os.environ.items() if name not in OF_MAKE}

    def run_there(self, *words, **settings) -> subprocess.CompletedProcess:
        return subprocess.run([str(word) for word in words], capture_output=True, text=True, errors="replace",
                              env={**self.environment, "AUTOGRADER": str(self.work), **settings})

    def archive(self) -> bytes:
        done = self.run_there("make", "gradescope")
        self.assertEqual(done.returncode, 0, done.stderr)
        return ARCHIVE.read_bytes()

    def unpack(self) -> None:
        """As unzip does it, with the permissions."""
        with zipfile.ZipFile(ARCHIVE) as archive:
            for info in archive.infolist():
                os.chmod(archive.extract(info, self.work / "source"), info.external_attr >> 16 or 0o644)

    def hand_in(self, *paths: Path) -> None:
        shutil.rmtree(self.submission, ignore_errors=True)
        self.submission.mkdir()
        for path in paths:
            if path.is_dir():
                shutil.copytree(path, self.submission / path.name)
            else:
                shutil.copy(path, self.submission / path.name)

    def says(self, sentence: str, score: str, words: str, **settings) -> None:
        """The contents of results.json: the score, the maximum, and the first words."""
        results = self.work / "results" / "results.json"
        done = self.run_there(self.work / "run_autograder", **settings)
        found = json.loads(results.read_text(encoding="utf-8"))
        results.unlink()
        marks = f"{found['score']:g} of {sum(test['max_score'] for test in found['tests']):g}" \
            if {"score", "tests"} & found.keys() else NO_MARK
        self.check(sentence, marks == score and found["output"].startswith(words),
                   (marks, found["output"][:80], done.stdout[-300:]))

    def path_where(self, program: str, line: str) -> str:
        """A PATH on which this program is a script of one line."""
        (self.work / "bin").mkdir(exist_ok=True)
        there = self.work / "bin" / program
        there.write_text(f'#!/bin/sh\n{line}\nexec {shutil.which(program)} "$@"\n')
        there.chmod(0o755)
        return f"{self.work / 'bin'}:{os.environ['PATH']}"

    def test_an_autograder(self):
        self.run_there("make", CLASS)
        first = self.archive()
        time.sleep(2)       # dates in an archive are even seconds
        self.check("the same tree makes the same archive", self.archive() == first)
        self.unpack()
        for name in ("setup.sh", "run_autograder"):
            self.check(f"{name} is at its root, to be started", os.access(self.work / "source" / name, os.X_OK))
        done = self.run_there(self.work / "source" / "setup.sh")
        self.check("setup.sh builds all that grading needs", done.returncode == 0, done.stderr[-400:])
        shutil.copy(self.work / "source" / "run_autograder", self.work)   # so does Gradescope

        self.hand_in(*CLASS.glob("another-way/*.c"))
        self.says("what is right has its marks", "24 of 100", "graded")
        self.hand_in(*CLASS.glob("does-not-compile/*.c"))
        self.says("what does not compile says so", "9 of 100", "does not compile")
        self.hand_in(Path("solutions"), Path("exercises"), Path("Makefile"), Path("tests/exercises.def"))
        shutil.copy(CLASS / "half-size" / "03-screen.c", self.submission / "exercises")
        self.says("of a whole toolkit, exercises/ is graded", "6 of 100", "graded")
        self.hand_in(CLASS / "blank")
        (self.submission / "exercises").symlink_to(self.toolkit / "solutions")
        (self.submission / "Makefile").touch()
        self.says("a link to the solutions is not followed", "0 of 100", "graded")
        shutil.rmtree(self.submission)
        self.says("an empty folder has a result", "0 of 100", "empty")
        self.hand_in(*CLASS.glob("another-way/*.c"))
        self.says("without a sandbox nothing is graded, and it says why", NO_MARK, "Nothing was graded", SANDBOX="none")
        killed = self.path_where("python3", '[ "$2" != tests/grade ] || kill -9 $$')
        self.says("a grader that is killed has no mark", NO_MARK, "The autograder did not", PATH=killed)
        # Each part of the grader is larger.
        self.says("a grader on a full disk has no mark", NO_MARK, "The autograder did not",
                  PATH=self.path_where("python3", '[ "$2" != tests/grade ] || ulimit -f 1'))
        (self.toolkit / "Makefile").unlink()
        self.says("a grader that is broken leaves a result", NO_MARK, "The autograder did not")
        self.toolkit.rename(self.work / "gone")
        self.says("so does one that is gone", NO_MARK, "The autograder did not")
