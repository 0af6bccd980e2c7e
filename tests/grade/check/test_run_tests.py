"""test_run_tests.py - what failed is counted and printed, and what did not is counted."""
import contextlib
import io
import unittest

from .run_tests import Counting, finish
from .sentences import Sentences


class Some(Sentences):
    def two_sentences_hold_and_one_does_not(self):
        self.check("one", True)
        self.check("two is odd", 2 % 2, "an even number")
        self.check("three", 3)

    def passes(self):
        pass

    def fails(self):
        self.assertEqual(1, 2)

    def raises_after_a_sentence(self):
        self.check("one", True)
        raise OSError("no disk")

    def skips(self):
        self.skip("what is not here")

    def is_skipped(self):
        self.skipTest("it all")


class Counts(unittest.TestCase):
    def run_these(self, *names):
        """The counts, the exit status, and what is printed."""
        result = Counting()
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            unittest.TestSuite(map(Some, names)).run(result)
            status = finish("some", result)
        return result.passed, result.failed, status, printed.getvalue()

    def test_each_sentence_counts(self):
        passed, failed, status, printed = self.run_these("two_sentences_hold_and_one_does_not")
        self.assertEqual((passed, failed, status), (2, 1, 1))
        self.assertIn("not ok: two is odd\n", printed)
        self.assertIn("saw an even number", printed)
        self.assertTrue(printed.endswith("\nsome: 2 passed, 1 failed\n"))

    def test_a_test_without_sentences_counts_once(self):
        self.assertEqual(self.run_these("passes", "passes"), (2, 0, 0, "some: 2 passed, 0 failed\n"))
        passed, failed, status, printed = self.run_these("passes", "fails")
        self.assertEqual((passed, failed, status), (1, 1, 1))
        self.assertRegex(printed, "not ok: .*Some.fails\n(.*\n)*.*1 != 2")

    def test_one_that_does_not_come_to_its_end_has_failed(self):
        passed, failed, status, printed = self.run_these("raises_after_a_sentence")
        self.assertEqual((passed, failed, status), (1, 1, 1))
        self.assertIn("no disk", printed)

    def test_what_is_skipped_has_not_passed(self):
        self.assertEqual(self.run_these("skips", "is_skipped"),
                         (0, 0, 1, "skipped: what is not here\nskipped: it all\nsome: 0 passed, 0 failed\n"))
