"""check - runs tests of the grader as make check wants them: what failed, line by line, then a sum.

    python3 -B tests/grade/check NAME MODULE...

The modules are unittest's: python3 -m unittest also runs them. A test with sentences (fixtures.py) counts as
many as it has, another one counts once.
"""
import sys
import traceback
import unittest
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[2])  # there the package is found


class Counting(unittest.TestResult):
    """Prints what failed, at once."""

    def __init__(self):
        super().__init__()
        self.passed = self.failed = 0
        self.sentences = 0      # of the test that is running

    def startTest(self, test):
        super().startTest(test)
        self.sentences = 0

    def not_ok(self, sentence, error) -> None:
        self.failed += 1
        trace = "".join(traceback.format_exception(*error, limit=-2))
        print(f"not ok: {sentence}\n    " + trace.strip().replace("\n", "\n    "), flush=True)

    def addSubTest(self, test, subtest, error):
        self.sentences += 1
        if error is None:
            self.passed += 1
        else:
            self.not_ok(subtest._message, error)

    def addSuccess(self, test):
        self.passed += not self.sentences

    def addFailure(self, test, error):
        self.not_ok(test.id().replace("_", " "), error)

    addError = addFailure

    def addSkip(self, test, reason):
        self.sentences += 1
        print(f"skipped: {reason}", flush=True)


def main(name: str, *modules: str) -> int:
    """The exit status; a run without tests also fails."""
    result = Counting()
    suite = unittest.defaultTestLoader.loadTestsFromNames([f"grade.check.{module}" for module in modules])
    suite.run(result)
    print(f"{name}: {result.passed} passed, {result.failed} failed")
    return 1 if result.failed or not result.passed else 0


sys.exit(main(*sys.argv[1:]))
