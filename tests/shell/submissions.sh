#!/bin/sh
# submissions.sh - what is a submission, and what it is worth: modules of the grader.
exec python3 -B tests/grading/run_tests.py submissions test_names test_submissions test_folders \
    test_archives test_broken_archives test_bombs test_policy
