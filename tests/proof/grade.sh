#!/bin/sh
# grade.sh - a grader that is killed, shared, and started again gives the same marks, and a failure of the machine is
# never a mark; archives that grow when they are opened; the archive for Gradescope, built, installed, given submissions.
. tests/house/runner/library.sh
once grading "a grader that is killed, shared, and started again"
needs_grading grading 'grading, long'
python3 -B tests/grade/check "grading, long" test_regrade test_faults test_bombs test_gradescope
