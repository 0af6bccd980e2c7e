"""test_regrade.py - a grader that is killed, shared, and started again gives the same marks."""
from __future__ import annotations

import json
import os
import random
import shutil
import signal
import subprocess
import time
from pathlib import Path

from grade.people.history import members
from .fixtures import Sentences
from .small_class import SEED, build_class, command, grade, records, right, rows, started


def kept(done: subprocess.CompletedProcess) -> int:
    """How many were not marked again."""
    return done.stderr.count("(kept)")


def was_compiled(folder: Path) -> bool:
    """When it was marked last."""
    return json.loads((folder / "results.json").read_text())["extra_data"]["record"]["steps"]["compile"] > 0


class Regrade(Sentences):
    def same_marks(self, folder: Path, work: Path, found: dict[str, dict]) -> None:
        if "bubblewrap" in next(iter(found.values()))["sandbox"]:
            grade(folder, work / "landlock", SANDBOX="landlock")
            theirs = records(work / "landlock")
            self.check("same marks under Landlock alone",
                       {name: record["stems"] for name, record in theirs.items()}
                       == {name: record["stems"] for name, record in found.items()},
                       {name: record["status"] for name, record in theirs.items()})

    def killed_and_started_again(self, folder: Path, work: Path, found: dict[str, dict]) -> None:
        chance = random.Random(7)
        out = work / "killed"
        for kill in ("SIGKILL", "SIGINT", "SIGTERM", "SIGKILL") * 5:
            grader = started(folder, out, JOBS="2")
            time.sleep(chance.uniform(0.2, 1.6))
            grader.send_signal(signal.Signals[kill])
            grader.communicate()
            whole = records(out)    # json.loads fails on half a file
            self.check(f"what is there after {kill} is whole", all(whole[name] == found[name] for name in whole))
        before = {path: path.stat().st_mtime_ns for path in out.glob("*/results.json")}
        done = grade(folder, out)
        self.check("started again, it does what is left", done.returncode == 0 and records(out) == found,
                   done.stderr[-500:])
        self.check("and nothing twice", all(path.stat().st_mtime_ns == at for path, at in before.items())
                   and kept(done) == len(before), done.stderr)
        self.check("no half of a file is left",
                   not list(out.glob("*/.*.new")) and not list((out / ".work").glob("*-of-*/*")))
        again = grade(folder, out)
        self.check("a third time there is nothing to do", kept(again) == len(found), again.stderr)

    def what_has_changed_is_marked_again(self, folder: Path, work: Path, found: dict[str, dict]) -> None:
        copy, out = work / "changing", work / "changed"
        shutil.copytree(folder, copy)
        grade(copy, out, JOBS="1")
        self.check("same seed, same marks with one job", records(out) == found)
        (copy / "nothing" / "03-screen.c").write_text(right("03-screen"))
        done = grade(copy, out)
        self.check("only what was handed in again is marked again", kept(done) == len(records(out)) - 1, done.stderr)
        self.check("and has its new marks", records(out)["nothing"]["score"] == 9)
        for name in set(os.listdir(copy)) - {"mirrored", "nothing", "no text"}:
            subprocess.run(["rm", "-r", "--", str(copy / name)], check=True)
        refused = grade(copy, out)
        self.check("a few into the marks of a class are refused, and nothing is changed",
                   "say who: ONLY=" in refused.stderr and refused.returncode and len(members(out)) == 12, refused.stderr)
        only = grade(copy, out, ONLY="mirrored")
        self.check("one of them is marked again, and the class is whole",
                   (only.stderr.count("/1 mirrored"), len(members(out)), len(rows(out))) == (1, 12, 12), only.stderr)
        self.check("though there is a verdict", was_compiled(out / "mirrored"))
        few = work / "a mail"
        shutil.copytree(copy / "mirrored", few / "mirrored")
        self.check("of a folder of its own it is said that the class's folder counts later",
                   f"Put this into {copy.resolve()} as well" in grade(few, out, ONLY="mirrored").stderr)
        out = work / "few"
        grade(copy, out)
        grade(copy, out, EX="01")
        self.check("a chapter is judged again, and no other", was_compiled(out / "mirrored") and not was_compiled(out / "nothing"))
        done = grade(copy, out, SEED="1")
        self.check("another seed marks all again", (kept(done), done.stderr.count("/3 ")) == (0, 3), done.stderr)
        self.check("and that is said", f"was {SEED} and is 1 now: all is marked again" in done.stderr, done.stderr)
        other = work / "other version"
        shutil.copytree("tests/grade", other / "tests" / "grade")
        shutil.copytree("solutions", other / "solutions")
        (other / "build").symlink_to(Path("build").resolve())
        with open(other / "tests/grade/confine/machine.py", "a") as rules:
            rules.write("# another rule\n")
        words = [str(other / word) if word == "tests/grade" else word for word in command(copy, out)]
        done = subprocess.run(words, env={**os.environ, "SEED": "1"}, capture_output=True, text=True, errors="replace")
        self.check("what another version of the rules for marks has kept is marked again",
                   (kept(done), done.stderr.count("/3 ")) == (0, 3), done.stderr)

    def shards_share_the_work(self, folder: Path, work: Path, found: dict[str, dict]) -> None:
        if shutil.which("parallel") is None:
            self.skip("sharing the work: no GNU parallel (make setup FOR=contributor)")
            return
        out = work / "shards"
        done = subprocess.run(["parallel", "--will-cite", "-j3", "env", "SHARD={}", *command(folder, out),
                               ":::", "1/3", "2/3", "3/3"],
                              env={**os.environ, "SEED": SEED, "JOBS": "1"}, capture_output=True, text=True)
        self.check("three shards under GNU parallel end well", done.returncode == 0, done.stderr[-500:])
        self.check("together they have done all, with the same marks", records(out) == found)
        merged = grade(folder, out)
        self.check("once more merges: nothing is marked again",
                   kept(merged) == len(found) and merged.returncode == 0, merged.stderr[-500:])
        self.check("and the class's reports are there", (out / "grades.csv").exists())

    def test_again(self) -> None:
        work, folder = self.work, self.work / "class"
        build_class(folder)
        grade(folder, work / "out", JOBS="4")
        found = records(work / "out")
        self.check("every submission has one result", len(found) == 12, list(found))
        self.same_marks(folder, work, found)
        self.killed_and_started_again(folder, work, found)
        self.what_has_changed_is_marked_again(folder, work, found)
        self.shards_share_the_work(folder, work, found)
