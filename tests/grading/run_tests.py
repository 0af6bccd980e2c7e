"""run_tests.py - runs Python tests as .make/check wants them: one line for what failed, then a sum.

    python3 -B tests/grading/run_tests.py NAME MODULE...
"""
import sys
import unittest


def main(name: str, *modules: str) -> int:
    result = unittest.TestResult()
    unittest.defaultTestLoader.loadTestsFromNames(modules).run(result)
    wrong = result.failures + result.errors
    for test, trace in wrong:
        print(f"not ok: {test.id().replace('_', ' ')}")
        print("    " + trace.strip().replace("\n", "\n    "))
    for test, reason in result.skipped:
        print(f"skipped {test.id().replace('_', ' ')}: {reason}")
    failed = len({test.id() for test, _ in wrong})
    print(f"{name}: {result.testsRun - failed - len(result.skipped)} passed, {failed} failed")
    return 1 if failed or not result.testsRun else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
