"""grader.py - one submission from its folder or archive to its results.json.

A result of the same files, seed, tests and sandbox is kept: so a grader that was stopped goes on where
it was. The policy and the ledger are not among these: when they change, marks are computed again from the kept
verdicts.
"""
from __future__ import annotations

import argparse
import copy
import hashlib
import os
import resource
import shutil
import subprocess
import time
from contextlib import contextmanager
from dataclasses import asdict, replace
from fractions import Fraction
from pathlib import Path

from grade import exercises
from grade import policy as policies
from grade.collect import submissions
from grade.collect.answers import UNREADABLE, Collected
from grade.collect.submissions import Submission
from grade.confine.machine import GraderFailed, limit
from grade.confine.sandbox import choose
from grade.people.ledger import Ledger, decide
from grade.report import files
from grade.report.points import FAILED, NOTHING
from grade.settings import seed_of_class

from .commands import read_kit
from .judging import calls_of
from .marking import add_marks, mark
from .verdicts import Verdicts
from .workbench import Workbench

DONE, KEPT = 0, 3       # exit statuses of the process that marks
WITHOUT_SCORE = (FAILED, UNREADABLE, NOTHING)   # nothing was computed
PERSON = ("name", "id", "login", "mail", "section")
PACKAGE = Path(__file__).resolve().parents[1]
SOLUTIONS = PACKAGE.parents[1] / "solutions"
# On these, and not on how reports look, verdicts depend.
GRADER = sorted(path for part in (".", "collect", "confine", "mark") for path in PACKAGE.glob(f"{part}/*.py"))
# Hostile archives get less memory and time than the process that opens them has.
COLLECTING = {resource.RLIMIT_AS: 2 << 30, resource.RLIMIT_CPU: 60}


def sum_of_files(paths: list[Path]) -> str:
    total = hashlib.sha256()
    for path in paths:
        total.update(path.read_bytes())
    return total.hexdigest()


@contextmanager
def limited(limits: dict[int, int]):
    before = {what: resource.getrlimit(what) for what in limits}
    for what, most in limits.items():
        limit(what, most)
    try:
        yield
    finally:
        for what, both in before.items():
            resource.setrlimit(what, both)


class Grader:
    """Everything that is the same for all submissions."""

    def __init__(self, given: argparse.Namespace):
        self.out = given.out.resolve()
        self.exercises = exercises.read()
        self.stems = exercises.stems(self.exercises)
        self.policy = policies.load(given.policy, self.exercises)
        self.asked = policies.judged(self.policy, self.stems)
        self.ledger = Ledger(None, self.stems, list, str)
        self.again: set[str] | None = set()     # folders of what is marked again; None: everybody's
        self.again_stems = self.asked           # and their chapters
        self.kit = read_kit(given.kit.resolve())
        self.sandbox = choose(given.kit.resolve() / "confine", given.sandbox, given.unsafe)
        self.seed, self.wanted_seed = 0, given.seed
        self.right: dict[str, bytes] = {}
        self.called: dict[str, set[str]] = {}
        part, parts = given.shard or (1, 1)
        self.work = self.out / ".work" / f"{part}-of-{parts}"
        self.tables = self.work / ".tables"
        confine = [Path(self.sandbox.confine)] if self.sandbox.confine else []
        self.tests = sum_of_files([exercises.LIST, *GRADER, Path(self.kit.judge_program), Path(self.kit.record_program),
                                   *sorted((self.kit.folder / "link").iterdir()),
                                   *(self.kit.folder / name for name in ("commands", "explain")), *confine])

    def begin(self) -> None:
        """When it is clear that there is something to mark, and nobody else does."""
        self.seed = seed_of_class(self.out, self.wanted_seed)
        self.verdicts(False).begin()
        files.clear(str(self.out / files.ANSWERS))

    def circumstances(self) -> str:
        """Changes with everything but the answers that verdicts depend on."""
        return hashlib.sha256("\n".join([str(self.seed), self.tests, self.sandbox.name]).encode()).hexdigest()

    def key(self, collected: Collected) -> str:
        """Changes with everything that the verdicts depend on."""
        parts = [submissions.digest(collected), self.circumstances()]
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()

    def verdicts(self, again: bool) -> Verdicts:
        return Verdicts(self.out / ".verdicts", self.circumstances(), frozenset(self.again_stems if again else ()))

    def place(self, submission: Submission) -> Path:
        return self.out / submission.folder

    def record(self, submission: Submission) -> dict | None:
        try:
            return files.read_record(str(self.place(submission) / "results.json"))
        except (OSError, ValueError):
            return None

    def points_of(self) -> dict[str, Fraction]:
        """STEM -> the points of the chapter."""
        return {stem: sum((Fraction(share, 100) for (chapter, _), share in self.policy.shares.items() if chapter == stem),
                          Fraction(0)) for stem in self.stems}

    def priced(self, record: dict, submission: Submission, when: int | None) -> dict:
        """The same verdicts with the marks that this policy and the ledger give them, and whose they are."""
        record = copy.deepcopy(record)
        decided = self.ledger.of(submission.key)
        for stem in record["stems"]:
            add_marks(stem, self.exercises, lambda stem, name: policies.points(self.policy, stem, name),
                      self.policy.waiting)

        def late(marks) -> tuple:
            return policies.late(self.policy, when, float(marks), decided.extra_days)

        if record["status"] in WITHOUT_SCORE:
            record["score"] = 0 if record["status"] == NOTHING else None
        else:
            record["score"], record["late"] = late(sum(stem["score"] for stem in record["stems"]))
        decide(record, decided, self.points_of(), lambda marks: marks - Fraction(str(late(marks)[0])))
        person = asdict(submission.person) if submission.person else {}
        record.update(when=when, submission=submission.name, unlisted=submission.unlisted,
                      person={field: person[field] for field in PERSON if person.get(field)})
        return record

    def mark(self, submission: Submission) -> int:
        """In a process of its own; gives its exit status."""
        began = time.monotonic()
        folder = self.work / submission.folder
        folder.mkdir(parents=True, exist_ok=True)
        with limited(COLLECTING):
            collected = submissions.collect(submission, self.stems,
                                            lambda command: self.sandbox.compiler(folder, [], command))
        whole = submissions.digest(collected)
        collected = replace(collected, answers={stem: collected.answers[stem] for stem in self.asked})
        if collected.status == UNREADABLE:
            return self.give_up_on(submission, collected.words)
        when = policies.came_in(self.policy, submission, collected)
        key, again = self.key(collected), self.again is None or submission.folder in self.again
        old = self.record(submission)
        if old is not None and old.get("key") == key and not again:
            return self.price_again(submission, old, when)
        bench = Workbench(self.kit, self.sandbox, self.work / submission.folder, self.tables, self.seed, self.right)
        files.keep_answers({stem: answer.text for stem, answer in collected.answers.items() if answer.state == "found"},
                           str(self.out), submission.folder)
        record = mark(bench, collected, self.exercises, self.called, self.verdicts(again))
        record.update(key=key, files=whole, folder=submission.folder,
                      seconds=round(time.monotonic() - began, 2),
                      steps={step: round(seconds, 3) for step, seconds in bench.seconds.items()})
        record = self.priced(record, submission, when)
        self.keep_pictures(record, self.place(submission), bench.folder)
        shutil.rmtree(bench.folder, ignore_errors=True)
        files.write_submission(record, str(self.place(submission)))
        return DONE

    def price_again(self, submission: Submission, old: dict, when: int | None) -> int:
        priced = self.priced(old, submission, when)
        if priced != old:
            files.write_submission(priced, str(self.place(submission)))
        return KEPT

    def without_marking(self, submission: Submission) -> dict | None:
        """The record of one that is not marked now: of somebody who handed in nothing, or as it was, with
        the marks of today."""
        if not submission.parts and not submission.is_elsewhere:
            return self.without_score(submission, NOTHING, "")
        old = self.record(submission)
        if old is not None and old["status"] != FAILED:
            self.price_again(submission, old, old.get("when"))
        return self.record(submission)

    def keep_pictures(self, record: dict, place: Path, drawn_in: Path) -> None:
        place.mkdir(exist_ok=True)
        for name, source in (("expected.png", self.kit.folder), ("yours.png", drawn_in)):
            if name in record["pictures"].values():
                shutil.copyfile(source / name, place / name)
            else:
                (place / name).unlink(missing_ok=True)

    def without_score(self, submission: Submission, status: str, words: str) -> dict:
        record = {"folder": submission.folder, "status": status, "words": words, "late": "", "stems": [],
                  "pictures": {}, "key": "", "files": "", "seed": self.seed, "seconds": 0,
                  "sandbox": self.sandbox.name, "unsafe": self.sandbox.unsafe}
        return self.priced(record, submission, None)

    def give_up_on(self, submission: Submission, words: str) -> int:
        """The result of a submission that cannot be read through its own fault. It has no score: nobody knows
        what it would have earned."""
        record = self.without_score(submission, UNREADABLE, words)
        if record == self.record(submission):
            return KEPT
        self.keep_pictures(record, self.place(submission), self.kit.folder)
        files.write_submission(record, str(self.place(submission)))
        return DONE

    def failed(self, submission: Submission, words: str) -> dict:
        """No score: the record of a submission that this grader could not mark. It replaces an older one, which
        may be of other files; its empty key has the submission marked again next time."""
        record = self.without_score(submission, FAILED, words)
        place = self.place(submission)
        shutil.rmtree(self.work / submission.folder, ignore_errors=True)
        try:
            (place / "results.json").unlink(missing_ok=True)
            files.write_submission(record, str(place))
        except OSError:
            pass    # the disk may be full; then it is in the reports of the class alone
        return record

    def make_tables(self) -> None:
        """The judge's tables of what is judged, with the hidden inputs of this seed. SystemExit if they cannot be made."""
        self.tables.mkdir(parents=True, exist_ok=True)
        environment = {**os.environ, "SEED": str(self.seed)}
        running = [(stem, subprocess.Popen([self.kit.record_program, stem, self.tables / f"{stem}.table"], env=environment,
                                           stderr=subprocess.PIPE, text=True)) for stem in self.asked]
        for stem, recording in running:
            _, words = recording.communicate()
            if recording.returncode:
                raise SystemExit(f"grade: nothing is graded, because the questions of {stem} cannot be made: "
                                 f"{words.strip() or recording.returncode}")

    def prove(self) -> None:
        """Marks the reference, which has all marks on a machine that can grade. SystemExit if it has not."""
        found = submissions.Submission("the reference", ".reference",
                                       (submissions.Part(os.fsencode(SOLUTIONS), "folder"),))
        bench = Workbench(self.kit, self.sandbox, self.work / found.folder, self.tables, self.seed, {})
        try:
            stems = mark(bench, submissions.collect(found, self.asked), self.exercises, {})["stems"]
            self.called = calls_of(bench, [exercise for exercise in self.exercises if exercise.stem in self.asked])
            self.right = {stem: (bench.folder / f"{stem}.o").read_bytes() for stem in self.asked}
        except (GraderFailed, OSError) as error:
            raise SystemExit(f"grade: nothing is graded, because the grader fails on the reference: {error}") from None
        finally:
            shutil.rmtree(bench.folder, ignore_errors=True)
        for stem in stems:
            if stem["state"] != "judged":
                refuse(stem["stem"], f"{stem['state']}: {stem['words']}")
            for function in stem["functions"]:
                if function["state"] != "right":
                    refuse(f"{stem['stem']}, {function['name']}",
                           f"{function['state']}: {function['how'] or function['test']}")


def refuse(where: str, words: str) -> None:
    raise SystemExit("grade: nothing is graded, because the reference (solutions/) does not get all marks on this "
                     f"machine:\n  {where}: {words}\n"
                     "  Either solutions/ is not as it was, or this compiler and the tests do not fit.")
