"""run_tests.py - runs Python tests as tests/check.c wants them: what failed, line by line, then a sum.

    python3 -B tests/grade/check NAME MODULE...

A module of this folder holds unittest's classes, or a list TESTS of functions that check sentences.
"""
import importlib
import sys
import traceback
import unittest

from . import sentences


def run_sentences(module) -> None:
    for test in module.TESTS:
        try:
            test()
        except Exception:  # a failure, and not the end of the other tests
            sentences.check(f"{module.__name__}.{test.__name__} came to its end", False)
            traceback.print_exc(limit=-4, file=sys.stdout)


def run_classes(module) -> None:
    result = unittest.TestResult()
    unittest.defaultTestLoader.loadTestsFromModule(module).run(result)
    wrong = {}
    for test, trace in result.failures + result.errors:
        wrong.setdefault(test.id().replace("_", " "), []).append(trace)
    for sentence, traces in wrong.items():
        sentences.check(sentence, False)
        print("    " + "\n".join(traces).strip().replace("\n", "\n    "))
    for test, reason in result.skipped:
        sentences.skip(f"{test.id().replace('_', ' ')}: {reason}")
    sentences.passed += result.testsRun - len(wrong) - len(result.skipped)


def main(words: list) -> int:
    name, *modules = words
    for module in map(importlib.import_module, (f"grade.check.{module}" for module in modules)):
        (run_sentences if hasattr(module, "TESTS") else run_classes)(module)
    return sentences.finish(name)
