"""sentences.py - a test that asserts several things of one run, each in a sentence of its own.

One that does not hold is a failure by that name, and the others are still looked at.
"""
import unittest


class Sentences(unittest.TestCase):
    maxDiff = None

    def check(self, sentence: str, holds, seen: object = "") -> None:
        """holds: what is asserted; seen: what was there instead."""
        with self.subTest(sentence):
            self.assertTrue(holds, f"saw {str(seen)[:600]}")

    def skip(self, why: str) -> None:
        with self.subTest(why):
            self.skipTest(why)
