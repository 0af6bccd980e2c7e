#!/bin/sh
# gradescope.sh - the archive for Gradescope: built, installed, and given submissions.
. tests/house/runner/library.sh
once gradescope "the autograder's archive"
needs_grading gradescope 'Gradescope'
python3 -B tests/grade/check gradescope test_gradescope
