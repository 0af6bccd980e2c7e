"""test_report_files.py - a file is whole or not there, also when its writer is killed."""
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
import xml.dom.minidom
from pathlib import Path
from unittest import mock

from grade.report import files
from grade.report.points import clean
from . import read_back
from .fixtures import Sentences
from .records import hostile_class, ordinary_class

PACKAGES = Path(__file__).resolve().parents[2]
READERS = {"grades.csv": read_back.strict_csv, "grades.tap": read_back.tap_points,
           "junit.xml": xml.dom.minidom.parseString, "group 02/results.json": json.loads,
           "index.html": lambda data: read_back.Page(data.decode()).open == [] or 1 / 0}
CLASS = {name for name in READERS if "/" not in name}


def contents(folder: Path) -> dict:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


class ReportFiles(Sentences):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = Path(folder.name)

    def test_round_trip(self):
        them = hostile_class() + ordinary_class()
        for one in them:
            files.write_submission(one, str(self.out / one["folder"]))
        read = [files.read_record(str(self.out / one["folder"] / "results.json")) for one in them]
        self.check("a record that was written is read as it was", read == [clean(one) for one in them])
        files.write_class(them, str(self.out))
        before = contents(self.out)
        files.write_class(read[::-1], str(self.out))
        self.check("class reports from what was read, in another order, are the same bytes", before == contents(self.out))
        self.check("a submission has its two files, the class its reports, and nothing else is left", set(before) == CLASS | {
            f"{one['folder']}/{name}" for one in them for name in ("index.html", "results.json")}, list(before))
        os.rename(self.out / "h00", self.out / "moved")
        self.check("a folder that was renamed is found again",
                   files.read_record(str(self.out / "moved" / "results.json"))["folder"] == "moved")

    def test_hash_seeds(self):
        # Python's sets and hashes differ from run to run; what is written must not.
        program = ("import sys; from grade.check import records; from grade.report import files;"
                   "files.write_class(records.ordinary_class(), sys.argv[1]);"
                   "files.write_submission(records.hostile_class()[9], sys.argv[1] + '/one');")
        written = []
        for seed in ("1", "2"):
            subprocess.run([sys.executable, "-B", "-c", program, self.out / seed], check=True, cwd=PACKAGES,
                           env={**os.environ, "PYTHONHASHSEED": seed, "LC_ALL": "C"})
            written.append(contents(self.out / seed))
        self.check("two runs write the same bytes, whatever the locale", written[0] == written[1] and len(written[0]) == 6)

    def test_whole_or_not(self):
        one, out = ordinary_class()[0], str(self.out)
        files.write_submission(one, out)
        before = contents(self.out)
        with self.assertRaises(ValueError):     # a mark that is none
            files.write_submission({**one, "submission": "b", "score": float("inf")}, out)
        with self.assertRaises(OSError), mock.patch("os.replace", side_effect=OSError("disk full")):
            files.write_submission({**one, "submission": "b"}, out)
        self.check("if it fails, the older files stay, alone", before == contents(self.out))
        with mock.patch("os.replace", side_effect=os.replace) as replaced:
            files.write_submission(one, out)
        self.check("results.json comes last", [os.path.basename(call.args[1]) for call in replaced.call_args_list]
                   == ["index.html", "results.json"])
        fresh, old = self.out / ".index.html.1.new", self.out / ".index.html.2.new"
        fresh.touch()
        old.touch()
        os.utime(old, (time.time() - 7200,) * 2)
        files.write_submission(one, out)
        self.check("what a killed grader left is cleared away, another's work is not", fresh.exists() and not old.exists())

    def test_no_record(self):
        path = self.out / "results.json"
        for words in ("", "{", "[]", "null", "{}", '{"extra_data": 1}', '{"extra_data": {"record": []}}', "\x00"):
            path.write_text(words, encoding="utf-8")
            with self.subTest(f"no record is found in {words!r}"), self.assertRaises(ValueError):
                files.read_record(str(path))

    def test_killed(self):
        """The writer writes two classes by turns for as long as it lives."""
        chance, sizes = random.Random(3), set()
        classes = ordinary_class(), ordinary_class()[:5]
        for _ in range(25):
            child = os.fork()
            if child == 0:
                try:
                    while True:
                        for them in classes:
                            files.write_class(them, str(self.out))
                            files.write_submission(them[1], str(self.out / "group 02"))
                finally:
                    os._exit(1)
            # The first may take its time until there is something to be seen.
            until = time.monotonic() + 60
            while not (self.out / "grades.csv").exists() and time.monotonic() < until:
                time.sleep(0.01)
            time.sleep(chance.uniform(0.02, 0.12))
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            for name, read in READERS.items():
                if (self.out / name).exists():
                    found = read((self.out / name).read_bytes())    # which fails on half a file
                    if name == "grades.csv":
                        sizes.add(len(found))
        self.check("whenever its writer is killed, each file is one of those that were written", sizes and sizes <= {6, 13})
