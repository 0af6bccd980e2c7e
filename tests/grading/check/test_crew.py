"""test_crew.py - whatever becomes of the processes, each submission has one result."""
import contextlib
import io
import os
import time
import unittest
from types import SimpleNamespace
from unittest import mock

import crew
from grader import DONE, KEPT

ENDS = {"done": lambda: DONE, "kept": lambda: KEPT, "raises": lambda: 1 // 0, "leaves": lambda: os._exit(7),
        "is killed": lambda: os.kill(os.getpid(), 9), "hangs": lambda: time.sleep(60) or DONE}


class Crew(unittest.TestCase):
    def marked(self, submissions, jobs):
        """What was given up on, and the lines of progress."""
        given_up = []
        grader = SimpleNamespace(
            mark=lambda name: ENDS[name](),
            give_up_on=lambda name, status, words: given_up.append((name, status, words)),
            record=lambda name: {"submission": name, "status": "graded", "score": 1, "max": 2})
        with contextlib.redirect_stderr(io.StringIO()) as said:
            crew.mark_all(grader, submissions, jobs)
        return sorted(given_up), said.getvalue().splitlines()

    def test_who_did_not_come_to_an_end_has_a_result_with_words(self):
        with mock.patch("crew.MOST_SECONDS", 0.5):
            given_up, said = self.marked(list(ENDS), 3)
        early = "the grader itself ended early ({}): please report it"
        self.assertEqual(given_up, [
            ("hangs", "timed out", "took more than 0.5 s in all"),
            ("is killed", "crashed", early.format(-9)),
            ("leaves", "crashed", early.format(7)),
            ("raises", "crashed", early.format(1))])
        self.assertEqual(sorted(line.split(" ", 1)[1] for line in said),
                         sorted(f"{name}: graded, 1 of 2" + (" (kept)" if name == "kept" else "")
                                for name in ENDS))

    def test_no_more_work_at_a_time_than_there_are_jobs(self):
        with mock.patch.dict(ENDS, {f"nap {i}": lambda: time.sleep(0.1) or DONE for i in range(4)}):
            began = time.monotonic()
            self.marked([f"nap {i}" for i in range(4)], 2)
            self.assertGreater(time.monotonic() - began, 0.2)

    def test_nobody_is_left_when_the_grader_is_stopped(self):
        children = []
        begin = crew.start

        def start(*both):
            children.append(begin(*both))
            if len(children) == 3:
                raise KeyboardInterrupt
            return children[-1]
        with mock.patch("crew.start", start), self.assertRaises(KeyboardInterrupt):
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
