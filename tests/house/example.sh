#!/bin/sh
# example.sh - the instructor's page and its ten submissions.
# Only reads the tree.
. tests/house/runner/library.sh
needs_grading example 'the example of grading'
python3 -B tests/grade/check example test_example
