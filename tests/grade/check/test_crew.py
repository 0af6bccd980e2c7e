"""test_crew.py - whatever becomes of the processes, each submission has one result."""
import contextlib
import io
import os
import time
import unittest
from types import SimpleNamespace
from unittest import mock

from grade.mark import crew
from grade.mark.grader import DONE, KEPT
from grade.confine.machine import GraderFailed

ENDS = {"done": lambda: DONE, "kept": lambda: KEPT, "raises": lambda: 1 // 0, "leaves": lambda: os._exit(7),
        "fails": lambda: fail("the disk is full"), "is killed": lambda: os.kill(os.getpid(), 9),
        "hangs": lambda: time.sleep(60) or DONE}


def fail(words):
    raise GraderFailed(words)


class Crew(unittest.TestCase):
    def marked(self, submissions, jobs):
        """The submissions that were given up, and the progress lines."""
        grader = SimpleNamespace(
            mark=lambda one: ENDS[one.folder](),
            failed=lambda one,
            words: {"submission": one.folder, "status": "grader failed", "score": None, "words": words},
            record=lambda one: {"submission": one.folder, "status": "graded", "score": 1, "max": 2})
        with contextlib.redirect_stderr(io.StringIO()) as said:
            failed = crew.mark_all(grader, [SimpleNamespace(folder=name) for name in submissions], jobs)
        return {name: record["words"] for name, record in failed.items()}, said.getvalue().splitlines()

    def test_who_did_not_come_to_an_end_has_no_score_and_a_reason(self):
        failed, said = self.marked([name for name in ENDS if name != "hangs"], 3)
        with mock.patch("grade.mark.crew.MOST_SECONDS", 0.5):
            hung, said_of_it = self.marked(["hangs"], 3)
        failed, said = failed | hung, said + said_of_it
        early = "the process that marks it ended with "
        self.assertEqual(failed, {
            "fails": "the disk is full",
            "hangs": "marking it took more than 0.5 s",
            "is killed": early + "signal 9",
            "leaves": early + "exit status 7",
            "raises": "ZeroDivisionError: integer division or modulo by zero (please report this)"})
        self.assertEqual(sorted(line.split(" ", 1)[1] for line in said),
                         sorted(f"{name}: grader failed, no score" if name in failed else
                                f"{name}: graded, 1 of 2" + (" (kept)" if name == "kept" else "")
                                for name in ENDS))

    def test_no_process_at_all_is_no_score_either(self):
        with mock.patch("grade.mark.crew.start", side_effect=OSError(11, "no more processes")):
            failed, _ = self.marked(["done", "kept"], 2)
        self.assertEqual(failed, dict.fromkeys(["done", "kept"], "cannot be started: no more processes"))

    def test_no_more_work_at_a_time_than_there_are_jobs(self):
        with mock.patch.dict(ENDS, {f"nap {i}": lambda: time.sleep(0.1) or DONE for i in range(4)}):
            began = time.monotonic()
            self.marked([f"nap {i}" for i in range(4)], 2)
            self.assertGreater(time.monotonic() - began, 0.2)

    def test_nobody_is_left_when_the_grader_is_stopped(self):
        children = []
        begin = crew.start

        def start(*both):
            began = begin(*both)
            children.append(began[0])
            if len(children) == 3:
                raise KeyboardInterrupt
            return began
        with mock.patch("grade.mark.crew.start", start), self.assertRaises(KeyboardInterrupt):
            self.marked(["hangs"] * 3, 3)
        crew.end(children[2])   # it was stopped before this one was known
        os.waitpid(children[2], 0)
        for child in children:
            self.assertRaises(ProcessLookupError, os.kill, child, 0)

    def test_shards_have_everybody_once(self):
        everybody = [SimpleNamespace(folder=f"group {i}") for i in range(100)]
        parts = [crew.of_shard(everybody, (part, 3)) for part in (1, 2, 3)]
        self.assertEqual(sorted(one.folder for part in parts for one in part),
                         sorted(one.folder for one in everybody))
        self.assertEqual(crew.of_shard(everybody[:50], (1, 3)),
                         [one for one in parts[0] if one in everybody[:50]])
        self.assertTrue(all(len(part) > 20 for part in parts))
        self.assertEqual(crew.of_shard(everybody, None), everybody)
