"""test_marking.py - whatever becomes of the processes, each submission has one result; the judge's report is read
whole; and who has marks though it fails.
"""
import contextlib
import io
import os
import time
import unittest
from types import SimpleNamespace
from unittest import mock

from grade.confine.machine import GraderFailed, believed
from grade.mark import crew
from grade.mark.grader import DONE, KEPT
from grade.mark.judging import calls_among, may_wait, waiting
from grade.mark.workbench import read_report
from .fixtures import WithFolder

ENDS = {"done": lambda: DONE, "kept": lambda: KEPT, "raises": lambda: 1 // 0, "leaves": lambda: os._exit(7),
        "fails": lambda: fail("the disk is full"), "is killed": lambda: os.kill(os.getpid(), 9),
        "hangs": lambda: time.sleep(60) or DONE}


def fail(words):
    raise GraderFailed(words)


class Doubt(unittest.TestCase):
    def believed(self, **looks):
        """What is believed of each, and how often it was looked at. looks: in the order in which they are had."""
        later = {name: list(found) for name, found in looks.items()}
        found = believed({name: found.pop(0) for name, found in later.items()}, lambda status: status != 0,
                         lambda name: later[name].pop(0))
        return found, {name: len(looks[name]) - len(later[name]) for name in looks}

    def test_what_is_right_is_looked_at_once(self):
        self.assertEqual(self.believed(a=[0], b=[0]), ({"a": 0, "b": 0}, {"a": 1, "b": 1}))

    def test_a_refusal_is_believed_the_second_time(self):
        self.assertEqual(self.believed(a=[0], b=[90, 91, 0]), ({"a": 0, "b": 91}, {"a": 1, "b": 2}))

    def test_while_looks_differ_there_is_another_one(self):
        self.assertEqual(self.believed(a=[1, 0], b=[1, 1, 0], c=[1, 1, 1, 1]),
                         ({"a": 0, "b": 0, "c": 1}, {"a": 2, "b": 3, "c": 4}))


class Crew(WithFolder):
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

    def test_two_graders_that_would_mark_the_same_are_refused(self):
        work = self.work / "out/.work"
        for first, second, is_refused in (("1-of-1", "1-of-1", True), ("1-of-1", "1-of-2", True),
                                          ("1-of-2", "1-of-1", True), ("1-of-2", "1-of-2", True),
                                          ("1-of-2", "2-of-2", False), ("2-of-3", "1-of-2", True),
                                          ("1-of-2", "1-of-12", True)):
            with crew.alone(work / first):
                try:
                    crew.alone(work / second).close()
                    refused = ""
                except SystemExit as error:
                    refused = str(error)
            self.assertEqual("another grader is at work here" in refused, is_refused, (first, second, refused))
            crew.alone(work / second).close()

    def test_shards_have_everybody_once(self):
        everybody = [SimpleNamespace(folder=f"group {i}") for i in range(100)]
        parts = [crew.of_shard(everybody, (part, 3)) for part in (1, 2, 3)]
        self.assertEqual(sorted(one.folder for part in parts for one in part),
                         sorted(one.folder for one in everybody))
        self.assertEqual([len(part) for part in parts], [34, 33, 33])
        self.assertEqual(crew.of_shard(everybody[::-1], (1, 3)), parts[0])
        self.assertTrue(all(len({one.folder for one in part} & {f"group {i}" for i in range(33)}) > 5 for part in parts))
        self.assertEqual(crew.of_shard(everybody, None), everybody)


REPORT = """function\tupper_left
state\twrong
given\tcamera\\teye (1, 2, 3)\\nray\\tt~1
yours\tback\\\\slash \\x1b \\n
function\tupper_right
state\tright
"""


class Report(WithFolder):
    def read(self, text, *names):
        path = self.work / "report"
        if text is not None:
            path.write_bytes(text.encode("latin-1"))
        return read_report(path, names)

    def test_each_function_has_its_values(self):
        self.assertEqual(self.read(REPORT, "upper_right", "upper_left"), {
            "upper_left": {"state": "wrong", "given": "camera\teye (1, 2, 3)\nray\tt~1",
                           "yours": "back\\slash \\x1b \n"},
            "upper_right": {"state": "right"}})

    def test_a_function_that_is_missing_is_the_grader_s_failure(self):
        for text in (None, "", REPORT.replace("right\n", "\n"), REPORT[:40], REPORT + "yours\t\xe9\n"):
            with self.assertRaises(GraderFailed):
                self.read(text, "upper_left", "upper_right")


def judged(**states):
    return {name: {"state": state} for name, state in states.items()}


def calling(**calls):
    return {name: {"state": "wrong", "calls": others} for name, others in calls.items()}


class Calls(unittest.TestCase):
    def test_what_a_function_entered_it_calls(self):
        self.assertEqual(calls_among(calling(a="b of_an_earlier_chapter", b="", c="a b"), ["a", "b", "c"]),
                         {"a": ["b"], "b": [], "c": ["a", "b"]})

    def test_only_those_that_are_asked_for(self):
        self.assertEqual(calls_among(calling(a="b c", b="", c=""), ["a", "c"]), {"a": ["c"], "c": []})

    def test_a_report_without_calls_says_nothing(self):
        self.assertEqual(calls_among(judged(a="crashed", b="right"), ["a", "b"]), {"a": [], "b": []})

    def test_two_that_call_each_other_do_not_excuse_each_other(self):
        functions = calling(a="b c d", b="a c d", c="a b d", d="")
        self.assertEqual(calls_among(functions, ["a", "b", "c", "d"]), {"a": ["d"], "b": ["d"], "c": ["d"], "d": []})


class Marks(unittest.TestCase):
    def test_who_may_wait_for_whom(self):
        functions = judged(a="wrong", b="right", c="unanswered", d="waiting", e="wrong")
        self.assertEqual(may_wait(functions, {}), {"a": [], "d": ["a"], "e": ["a", "d"]})
        # A later one too, if the reference calls it in the same place.
        self.assertEqual(may_wait(functions, {"a": {"e"}}), {"a": ["e"], "d": ["a"], "e": ["a", "d"]})

    def test_only_an_attempt_is_worth_waiting_for(self):
        functions = judged(a="wrong", b="wrong", c="wrong", d="wrong")
        functions["a"]["mistake"] = "halves"
        self.assertEqual(waiting(functions, {"b": ["a"], "c": ["b"], "d": []}), {"b": ["a"], "c": ["b"]})
        functions["a"]["partly"] = "yes"
        self.assertEqual(waiting(functions, {"b": ["a"], "c": ["b"]}), {})

    def test_two_that_wait_for_each_other_have_none(self):
        functions = judged(a="wrong", b="wrong")
        self.assertEqual(waiting(functions, {"a": ["b"], "b": ["a"]}), {})
