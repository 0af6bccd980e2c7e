"""test_grade.py - the whole grader on a small class: it is fair, a change of the policy alone marks nothing again and
counts at once, and whatever this machine cannot do is one sentence, and no traceback.
"""
from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from datetime import datetime, timedelta, timezone
from pathlib import Path
from xml.etree import ElementTree

from .fixtures import Sentences
from grade.people.history import lines_of
from .small_class import KIT, STEMS, build_class, command, grade, records, right, rows


def function(record: dict, name: str) -> dict:
    return next(f for stem in record["stems"] for f in stem["functions"] if f["name"] == name)


# Of each submission its status, its score, and words about it or its chapter 01.
RESULTS = {
    "all right": ("graded", 100, ""),
    # A known mistake; another function fails only for it, and the reference calls it in the same place; an earlier one
    # also calls it, and fails.
    "mirrored": ("graded", 6, ""),
    "waits": ("graded", 8, ""),
    # In the compiler's words, and as 'make exercises' explains them; its other chapter has its marks.
    "no text": ("does not compile", 9, "return v.x"),
    "no assembler": ("does not compile", 0, ""),
    "-leading dash 'quote\" newline\n\x1b[31m =ü": ("graded", 9, ""),
    "nothing": ("empty", 0, ""),
    "broken": ("cannot be read", None, "the archive is broken"),
    "xaver": ("cannot be read", None, "01-corners.c cannot be read: it is encrypted"),
    "=1+1<b>.pdf": ("cannot be read", None, "a loose file, and neither a folder nor an archive"),
    "zoe_506": ("graded", 10, ""),      # of what was uploaded twice, the last counts
    "zipped": ("graded", 5, "a member's path leads out of the archive"),
}


class Grade(Sentences):
    def says_what_is_so(self, found: dict[str, dict]) -> None:
        self.check("every submission has one result", set(found) == set(RESULTS), set(found))
        for name, (status, score, words) in RESULTS.items():
            record = found[name]
            said = record["words"] + "".join(stem["words"] for stem in record["stems"])
            self.check(f"{name}: {status}, {score}", (record["status"], record["score"]) == (status, score) and words in said, record)
        self.check("a known mistake is named", function(found["mirrored"], "image_plane_vector")["mistake"] is not None)
        waits = function(found["waits"], "upper_right")
        self.check("it is said for what a function waits", waits["waiting_for"] == ["upper_left"], waits)
        explained, assembler = (found[name]["stems"][0]["words"] for name in ("no text", "no assembler"))
        self.check("what does not compile is explained", "a vec3 has no named parts" in explained, explained)
        self.check("the assembler's words are the same in every run and every sandbox",
                   "error" in assembler.lower() and "/" not in assembler, assembler)

    def says_what_cannot_be_read(self, table: dict[str, dict], page: str, told: str) -> None:
        row = table["'=1+1<b>.pdf"]
        reason = "a loose file, and neither a folder nor an archive"
        self.check("grades.csv: no score, in any column, and the reason",
                   row == {"submission": "'=1+1<b>.pdf", "status": "cannot be read", "final": "", "max": "100",
                           **dict.fromkeys([*STEMS[:-1], "computed", "late", "adjusted"], ""), "reason": reason}, row)
        self.check("the page of the class has the reason",
                   re.search("=1\\+1&lt;b&gt;.pdf</bdi></a><div[^>]*>cannot be read</div>\\s*<div[^>]*>"
                             + reason, page))
        self.check("the terminal has the reason", f"  =1+1<b>.pdf: {reason}\n" in told, told)
        self.check("it does not count in the median", "Cannot be read, or only partly: 3\n" in told
                   and len(re.findall(r"^ +0-9 +#+ (\d+)$", told, re.M)) == 1, told)

    def keeps_hidden_inputs(self, found: dict[str, dict]) -> None:
        hidden = [f for record in found.values() for stem in record["stems"]
                  for f in stem["functions"] if f["hidden"]]
        self.check("values of hidden inputs are in no record",
                   not any(f["given"] or f["expected"] or f["yours"] for f in hidden))

    def counts_by_another_policy(self, folder: Path, out: Path) -> None:
        """Other points, a due time, and no marks for what waits."""
        due = datetime.now(timezone.utc) - timedelta(hours=10)      # begun days count: one of them, a quarter
        policy = out.with_name("policy")
        policy.write_text("points others 0\npoints 01-corners 10\npoints 03-screen 20\nwaiting none\n"
                          f"due {due:%Y-%m-%dT%H:%MZ}\nlate 25% per day, at most 50%\n")
        done = grade(folder, out, POLICY=str(policy))
        self.check("with another policy it is graded", done.returncode == 0, done.stderr)
        steps = [json.loads(path.read_text())["extra_data"]["record"].get("steps") for path in out.glob("*/results.json")]
        self.check("and no chapter is compiled again", not any(one["compile"] for one in steps if one), steps)
        marks = {name: (row["final"], row["max"]) for name, row in rows(out).items()}
        self.check("the policy counts", marks["no text"] == ("15", "30") and marks["mirrored"] == ("3", "30"), marks)
        self.check("on the student's page too",
                   "15 of 30" in (out / "no text" / "index.html").read_text(encoding="utf-8"))
        waits = function(records(out)["waits"], "upper_right")
        failed = [case.get("name") for case in ElementTree.parse(out / "junit.xml").iter("testcase")
                  if case.find("failure") is not None]
        self.check("with 'waiting none' what waits has no marks, and does not pass", (waits["state"], waits["score"])
                   == ("waiting", 0) and "waits: 01-corners: upper_right" in failed, waits)
        why = {row[5] for row in lines_of(out)}
        self.check("the history says that the policy has changed, and not that anybody has handed in again",
                   "the policy has changed" in why and "handed in again" not in why, why)
        again = grade(folder, out)
        self.check("who forgets the policy has that of the last time, and is told",
                   {name: (row["final"], row["max"]) for name, row in rows(out).items()} == marks
                   and f"As the last time: POLICY={policy}" in again.stderr, again.stderr)
        for name in ("mirrored", "waits"):
            (folder.with_name("week 2") / name).mkdir(parents=True)
            (folder.with_name("week 2") / name / "05-quadratic.c").write_text(right("05-quadratic"))
        roster = folder.with_name("roster.csv")
        roster.write_text("name\nmirrored\nwaits\nabsent\n")
        policy.with_name("came in.csv").write_text("submission,time\nwaits,2025-11-14T22:59Z\n")
        policy.write_text(policy.read_text() + "times came in.csv\n")
        other = grade(folder.with_name("week 2"), folder.with_name("out of week 2"), POLICY=str(policy), CLASS=str(roster))
        self.check("a first class without these chapters is marked", other.returncode == 0, other.stderr)
        self.check("who has no time is named, but not who handed in nothing",
                   "Without a time, taken as on time: mirrored\n" in other.stderr, other.stderr)
        before = (out / "grades.csv").read_bytes()
        everybody = {path.name: "05-quadratic.c" for path in folder.iterdir()}
        for name in everybody:
            place = folder.with_name("week 3") / name.partition(".")[0]
            place.mkdir(parents=True, exist_ok=True)
            (place / "05-quadratic.c").write_text(right("05-quadratic"))
        refused = grade(folder.with_name("week 3"), out)
        self.check("another week's submissions do not take this one's marks away", refused.returncode != 0
                   and "is it another week's?" in refused.stderr and (out / "grades.csv").read_bytes() == before, refused.stderr)

    def test_class(self) -> None:
        folder, out = self.work / "class", self.work / "out"
        build_class(folder)
        done = grade(folder, out)
        found = records(out)
        table, page = rows(out), (out / "index.html").read_text(encoding="utf-8")
        self.check("the exit status is 0", done.returncode == 0, done.stderr[-600:])
        self.check("a file that is not a submission is mentioned", "read me.txt" in done.stderr)
        self.check("nothing acts on the terminal", "\x1b" not in done.stdout + done.stderr)
        self.says_what_is_so(found)
        self.keeps_hidden_inputs(found)
        self.says_what_cannot_be_read(table, page, done.stdout)
        self.counts_by_another_policy(folder, out)


# ---- the machine --------------------------------------------------------------------------------


def said(words: list[str], **settings) -> tuple[int, str]:
    stdout = settings.pop("stdout", subprocess.DEVNULL)
    done = subprocess.run(words, env={**os.environ, "SEED": "1", **settings}, stdin=subprocess.DEVNULL, stdout=stdout,
                          stderr=subprocess.PIPE, text=True, check=False)
    return done.returncode, done.stderr


class Environment(Sentences):
    def is_one_sentence(self, name: str, wanted: str, words: list[str], **settings) -> None:
        status, complaints = said(words, **settings)
        last = complaints.splitlines()[-1:] or [""]
        self.check(f"{name} is one sentence", status == 1 and last[0].startswith("grade: ") and wanted in last[0]
                   and "Traceback" not in complaints and complaints.count("grade: ") == 1, complaints)

    def test_environment(self) -> None:
        work = self.work
        folder, file = work / "class", work / "file"
        (folder / "anna").mkdir(parents=True)
        (folder / "anna" / "03-screen.c").write_text(right("03-screen"))
        file.write_text("x")
        shut = work / "shut"
        shut.mkdir()
        (shut / ".seed").write_bytes(b"\xff")
        nowhere = Path("/proc/out")
        for name, wanted, words, settings in (
                ("an OUT that is a file", f"OUT={file} cannot be written: ", command(folder, file), {}),
                ("an OUT in a file", f"OUT={file}/out cannot be written: ", command(folder, file / "out"), {}),
                ("an OUT where nothing can be made", f"OUT={nowhere} cannot be written: ", command(folder, nowhere), {}),
                ("a seed that is noise", "", command(folder, shut), {}),
                ("no kit", str(work / "none"), command(folder, work / "out", work / "none"), {}),
                ("a kit that is a file", str(file), command(folder, work / "out", file), {}),
                ("a policy that is a folder", "cannot be read", command(folder, work / "out"), {"POLICY": str(work)}),
                ("a class that is a file", "is a file", command(file, work / "out"), {}),
                ("a folder without submissions", "holds no submission", command(shut, work / "new seed"), {})):
            self.is_one_sentence(name, wanted, words, **settings)
        self.check("which changes nothing", not (work / "new seed").exists())
        with open("/dev/full", "w") as full:
            self.is_one_sentence("a full terminal", "its output: No space left", command(folder, work / "out"),
                                 stdout=full)
        self.read_only(folder, work)

    def test_it_starts_from_any_folder(self) -> None:
        words = [sys.executable, str(Path("tests/grade").resolve()), "--help"]
        done = subprocess.run(words, cwd="/", capture_output=True, text=True,
                              env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
        self.check("the grader starts from any folder", (done.returncode, done.stdout[:13]) == (0, "usage: grade "),
                   done.stderr)

    def test_a_tree_that_was_moved(self) -> None:
        """It was 'compiling something right also fails': the kit named the folder where the tree had been."""
        kit = shutil.copytree(KIT, self.work / "kit")
        compiler = [f"CC={os.environ['CC']}"] if "CC" in os.environ else []
        done = subprocess.run(["make", *compiler, f"KIT={kit}", f"{kit}/commands"], capture_output=True, text=True,
                              env={name: value for name, value in os.environ.items() if name != "MAKEFLAGS"})
        self.check("its kit names the folder where it is",
                   str(Path(KIT).resolve()) not in (kit / "commands").read_text(), done.stderr)

    def read_only(self, folder: Path, work: Path) -> None:
        view = ["bwrap", "--ro-bind", "/", "/", "--dev", "/dev", "--proc", "/proc"]
        if not shutil.which("bwrap") or said([*view, "true"])[0] != 0:
            self.skip("a file system that is read-only: no bubblewrap here")
            return
        for name in ("new", "old"):
            if name == "old":
                (work / name).mkdir()
            self.is_one_sentence(f"a read-only OUT ({name})", "cannot be written: Read-only file system",
                                 [*view, *command(folder, work / name)], SANDBOX="landlock")
