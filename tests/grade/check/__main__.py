"""check - runs tests of the grader as make check wants them: what failed, then a sum.

    python3 -B tests/grade/check NAME MODULE...

The modules are unittest's: python3 -m unittest also runs them.
"""
import sys
import unittest
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[2])  # there the package is found


def main(name: str, *modules: str) -> int:
    """The exit status; a run without tests also fails."""
    suite = unittest.defaultTestLoader.loadTestsFromNames([f"grade.check.{module}" for module in modules])
    result = unittest.TextTestRunner(sys.stdout, verbosity=0).run(suite)
    for _, reason in result.skipped:
        print(f"skipped: {reason}")
    failed = {getattr(test, "test_case", test) for test, _ in [*result.failures, *result.errors]}   # of several sentences
    print(f"{name}: {result.testsRun - len(failed)} passed, {len(failed)} failed")
    return 1 if failed or not result.testsRun else 0


sys.exit(main(*sys.argv[1:]))
