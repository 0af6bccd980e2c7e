"""test_pack.py - 'make submission' (tests/course/pack_submission.py)."""
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

from grade.collect import submissions
from .fixtures import Scratch

STEMS = sorted(path.stem for path in Path("solutions").glob("*.c"))


class Packing(Scratch):
    def setUp(self):
        super().setUp()
        self.answers, self.zip = self.work / "answers", self.room / "anna.zip"
        shutil.copytree("solutions", self.answers)

    def pack(self, archive=None) -> tuple:
        """Its exit status, what it printed, and what it complained of."""
        done = subprocess.run([sys.executable, "tests/course/pack_submission.py", str(archive or self.zip),
                               str(self.answers), "build/blanks", *STEMS],
                              capture_output=True, text=True, check=False)
        return done.returncode, done.stdout, done.stderr

    def blank(self, stem) -> str:
        return Path("build/blanks", f"{stem}.c").read_text()

    def test_all_answers_are_in_it_as_they_are(self):
        status, said, complaints = self.pack()
        self.assertEqual((status, complaints), (0, ""))
        with zipfile.ZipFile(self.zip) as archive:
            self.assertIsNone(archive.testzip())
            self.assertEqual(archive.namelist(), [f"{stem}.c" for stem in STEMS])
            for info in archive.infolist():
                self.assertEqual(archive.read(info), (self.answers / info.filename).read_bytes())
                self.assertEqual((info.external_attr >> 16, info.date_time), (0o100644, (1980, 1, 1, 0, 0, 0)))
        self.assertIn(f"Hand in this file: {self.zip} ({len(STEMS)} files)", said)
        self.assertNotIn("Not finished", said)

    def test_the_same_answers_make_the_same_bytes(self):
        self.pack()
        first = self.zip.read_bytes()
        for path in self.answers.iterdir():
            os.utime(path, (0, 0))
            path.chmod(0o777)
        (self.answers / "notes.txt").write_text("x")
        self.pack()
        self.assertEqual(self.zip.read_bytes(), first)

    def test_what_is_not_finished_is_said(self):
        asked = self.blank("01-corners").count("NOT_ANSWERED(")
        self.assertGreater(asked, 2)
        (self.answers / "01-corners.c").write_text(
            self.blank("01-corners").replace("return NOT_ANSWERED", "// return NOT_ANSWERED", 2))
        (self.answers / "02-cameras.c").write_text(self.blank("02-cameras") + "\n// later\n")
        (self.answers / "03-screen.c").rename(self.answers / "03-screen (1).c")
        status, said, _ = self.pack()
        lines = {line.split()[0]: line.split(None, 1)[1] for line in said.splitlines() if len(line.split()) > 1}
        self.assertEqual(status, 0)
        self.assertEqual(lines["01-corners.c"], f"{asked - 2} of {asked} functions not answered yet")
        self.assertEqual(lines["02-cameras.c"], "still blank")
        self.assertEqual(lines["03-screen.c"], "missing: there is '03-screen (1).c', rename it")
        self.assertIn("Not finished: 3 of the chapters", said)
        self.assertIn("  04-pixel-ray.c\n", said)
        with zipfile.ZipFile(self.zip) as archive:
            self.assertEqual(archive.namelist(), [f"{stem}.c" for stem in STEMS if stem != "03-screen"])

    def test_what_cannot_be_packed_leaves_the_older_archive(self):
        self.pack()
        first = self.zip.read_bytes()
        (self.answers / "05-quadratic.c").write_text("/" * (256 * 1024 + 1))
        status, _, complaints = self.pack()
        self.assertEqual(status, 1)
        self.assertIn("05-quadratic.c: larger than 256 KB", complaints)
        (self.answers / "05-quadratic.c").unlink()
        (self.answers / "05-quadratic.c").mkdir()
        self.assertEqual((self.pack()[0], self.zip.read_bytes()), (1, first))
        shutil.rmtree(self.answers)
        self.answers.mkdir()
        status, _, complaints = self.pack()
        self.assertEqual((status, complaints, self.zip.read_bytes()), (1, "There is no answer to hand in.\n", first))

    def test_where_it_cannot_be_written_is_said(self):
        status, said, complaints = self.pack("nowhere/x.zip")
        self.assertEqual((status, complaints.count("\n")), (1, 1), complaints)
        self.assertIn("nowhere/x.zip", complaints)
        self.assertNotIn("Hand in this file", said)

    def test_the_grader_reads_it(self):
        self.pack()
        found, _ = submissions.find(self.room)
        collected = submissions.collect(found[0], STEMS)
        self.assertEqual([(answer.state, answer.text) for answer in collected.answers.values()],
                         [("found", Path("solutions", f"{stem}.c").read_bytes()) for stem in STEMS])
        self.assertEqual(collected.words, "")
