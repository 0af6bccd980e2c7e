"""Starts the tests of the grader: python3 -B tests/grade/check NAME MODULE..."""
import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[2])  # there the package is found

from grade.check.run_tests import main  # noqa: E402 - found from there on

sys.exit(main(sys.argv[1:]))
