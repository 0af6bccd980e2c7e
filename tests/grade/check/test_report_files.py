"""test_report_files.py - a file is whole or not there, also when its writer is killed."""
import json
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time
import xml.dom.minidom

from grade.report import files
from grade.report.points import clean
from . import read_back
from .fixtures import Sentences
from .records import hostile_class, ordinary_class

PACKAGES = pathlib.Path(__file__).resolve().parents[2]
CLASS = {"grades.csv", "junit.xml", "grades.tap", "index.html"}


def listed(folder) -> set:
    return set(os.listdir(folder))


def raises(kind, call, *arguments) -> bool:
    try:
        call(*arguments)
    except kind:
        return True
    return False


class ReportFiles(Sentences):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = folder.name

    def test_round_trip(self):
        them = hostile_class() + ordinary_class()
        for one in them:
            files.write_submission(one, os.path.join(self.out, one["folder"]))
        read = [files.read_record(os.path.join(self.out, one["folder"], "results.json")) for one in them]
        self.check("a record that was written is read as it was", read == [clean(one) for one in them])
        self.check("a submission has its two files",
                   all(listed(os.path.join(self.out, one["folder"])) == {"index.html", "results.json"} for one in them))
        files.write_class(them, self.out)
        before = {name: pathlib.Path(self.out, name).read_bytes() for name in CLASS}
        files.write_class(read[::-1], self.out)
        self.check("class reports from what was read, in another order, are the same bytes",
                   before == {name: pathlib.Path(self.out, name).read_bytes() for name in CLASS})
        self.check("only the reports are left", listed(self.out) == CLASS | {one["folder"] for one in them})
        os.rename(os.path.join(self.out, "h00"), os.path.join(self.out, "moved"))
        self.check("a folder that was renamed is found again",
                   files.read_record(os.path.join(self.out, "moved", "results.json"))["folder"] == "moved")

    def test_hash_seeds(self):
        # Python's sets and hashes differ from run to run; what is written must not.
        program = (
            "import sys; from grade.check import records; from grade.report import files;"
            "files.write_class(records.ordinary_class(), sys.argv[1]);"
            "files.write_submission(records.hostile_class()[9], sys.argv[1] + '/one');"
        )
        written = []
        for seed in ("1", "2"):
            folder = os.path.join(self.out, seed)
            subprocess.run([sys.executable, "-B", "-c", program, folder], check=True, cwd=PACKAGES,
                           env={**os.environ, "PYTHONHASHSEED": seed, "LC_ALL": "C"})
            written.append({str(path.relative_to(folder)): path.read_bytes()
                            for path in pathlib.Path(folder).rglob("*") if path.is_file()})
        self.check("two runs write the same bytes, whatever the locale",
                   written[0] == written[1] and len(written[0]) == 6)

    def test_whole_or_not(self):
        one = ordinary_class()[0]
        files.write_submission(one, self.out)
        before = (
            pathlib.Path(self.out, "index.html").read_bytes(),
            pathlib.Path(self.out, "results.json").read_bytes(),
        )
        self.check(
            "a mark that is none is refused",
            raises(ValueError, files.write_submission, {**one, "submission": "b", "score": float("inf")}, self.out),
        )
        rename, os.replace = os.replace, lambda *paths: (_ for _ in ()).throw(OSError("disk full"))
        self.check("a full disk is reported",
                   raises(OSError, files.write_submission, {**one, "submission": "b"}, self.out))
        os.replace = rename
        self.check(
            "and the older files stay, alone",
            listed(self.out) == {"index.html", "results.json"}
            and before
            == (pathlib.Path(self.out, "index.html").read_bytes(), pathlib.Path(self.out, "results.json").read_bytes()),
        )
        order = []
        os.replace = lambda new, name: (order.append(os.path.basename(name)), rename(new, name))
        files.write_submission(one, self.out)
        os.replace = rename
        self.check("results.json comes last", order == ["index.html", "results.json"])
        fresh, old = pathlib.Path(self.out, ".index.html.1.new"), pathlib.Path(self.out, ".index.html.2.new")
        fresh.touch()
        old.touch()
        os.utime(old, (time.time() - 7200,) * 2)
        files.write_submission(one, self.out)
        self.check("what a killed grader left is cleared away, another's work is not",
                   fresh.exists() and not old.exists())

    def test_no_record(self):
        path = os.path.join(self.out, "results.json")
        for words in ("", "{", "[]", "null", "{}", '{"extra_data": 1}', '{"extra_data": {"record": []}}', "\x00"):
            pathlib.Path(path).write_text(words, encoding="utf-8")
            self.check(f"no record is found in {words!r}", raises(ValueError, files.read_record, path))

    def test_killed(self):
        # It writes two classes by turns for as long as it lives.
        chance = random.Random(3)
        whole, sizes = True, set()
        for _ in range(25):
            child = os.fork()
            if child == 0:
                try:
                    while True:
                        for them in (ordinary_class(), ordinary_class()[:5]):
                            files.write_class(them, self.out)
                            files.write_submission(them[1], os.path.join(self.out, "group 02"))
                finally:
                    os._exit(1)
            # The first may take its time until there is something to be seen.
            until = time.monotonic() + 60
            while not pathlib.Path(self.out, "grades.csv").exists() and time.monotonic() < until:
                time.sleep(0.01)
            time.sleep(chance.uniform(0.02, 0.12))
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            for name, read in (
                ("grades.csv", read_back.strict_csv),
                ("grades.tap", read_back.tap_points),
                ("junit.xml", xml.dom.minidom.parseString),
                ("group 02/results.json", json.loads),
                ("index.html", lambda data: read_back.Page(data.decode()).open == [] or 1 / 0),
            ):
                path = pathlib.Path(self.out, name)
                if path.exists():
                    try:
                        found = read(path.read_bytes())
                        if name == "grades.csv":
                            sizes.add(len(found))
                    except Exception as error:  # whatever a reader says
                        whole = False
                        print(f"{name}: {error}")
        self.check("whenever its writer is killed, each file is whole", whole)
        self.check("and one of those that were written", sizes and sizes <= {6, 13})
