#!/bin/sh
# grade.sh - 'make grade' on a small class, where it can be run.
. tests/house/runner/library.sh
needs_grading grading 'grading'
python3 -B tests/grade/check "grading, short" test_grade test_policy_change test_environment
