"""run_tests.py - runs tests as make check wants them: what failed, line by line, then a sum.

    python3 -B tests/grade/check NAME MODULE...

The modules are unittest's: python3 -m unittest also runs them. A test with sentences (sentences.py) counts as
many as it has, another one counts once.
"""
import traceback
import unittest


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


def finish(name: str, result: Counting) -> int:
    """The exit status; a run without tests also fails."""
    print(f"{name}: {result.passed} passed, {result.failed} failed")
    return 1 if result.failed or not result.passed else 0


def main(words: list) -> int:
    name, *modules = words
    result = Counting()
    suite = unittest.defaultTestLoader.loadTestsFromNames([f"grade.check.{module}" for module in modules])
    suite.run(result)
    return finish(name, result)
