"""test_waiting.py - who calls whom by the judge's report, and who then has marks though it fails."""
import unittest

from grade.mark.waiting import calls_among, may_wait, waiting

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
