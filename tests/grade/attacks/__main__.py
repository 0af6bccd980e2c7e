"""Starts the class of attacks: python3 -B tests/grade/attacks [SANDBOX | PART-OF-A-NAME]..."""
import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[2])  # there the package is found

from grade.attacks.run import main  # noqa: E402 - found from there on

sys.exit(main(sys.argv[1:]))
