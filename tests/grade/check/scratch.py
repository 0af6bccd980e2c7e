"""scratch.py - a folder for a class, and one submission in it, for each test."""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from grade.collect import submissions

STEMS = ["01-corners", "05-quadratic"]


class Scratch(unittest.TestCase):
    def setUp(self):
        self.top = Path(tempfile.mkdtemp())
        self.addCleanup(subprocess.run, ["rm", "-rf", str(self.top)], check=True)
        self.room = self.top / "class"
        self.room.mkdir()

    def put(self, name, content=b"int a;\n", who="anna"):
        path = os.path.join(os.fsencode(self.room / who), os.fsencode(name))
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as file:
            file.write(content)
        return path

    def collect(self):
        found, _ = submissions.find(self.room)
        self.assertEqual(len(found), 1)
        return submissions.collect(found[0], STEMS)

    def answer(self, stem="05-quadratic"):
        return self.collect().answers[stem]
