"""Starts the grader, from any working directory: python3 -B tests/grade KIT SUBMISSIONS."""
import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # there the package is found

from grade.command import main  # noqa: E402 - found from there on

sys.exit(main())
