#!/bin/sh
# submissions.sh - what is a submission, and what it is worth: modules of the grader.
exec python3 -B tests/grading/run_tests.py submissions test_names test_policy
