#!/bin/sh
# hostile.sh - a class of attacks on the grader, in every sandbox that there is.
set -u
. tests/house/runner/library.sh
once hostile "attacks in every sandbox"
needs_grading hostile "attacks on the grader"
python3 -B tests/grade/attacks
