#!/bin/sh
# grade.sh - 'make grade' on a small class, and on the ten submissions of the instructor's page.
# Only reads the tree.
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once grading "marking a small class"
needs_grading grading 'grading'
python3 -B tests/grade/check "grading, short" test_grade test_example
