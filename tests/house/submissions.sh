#!/bin/sh
# submissions.sh - what is a submission, and what it is worth: modules of the grader.
# Only reads the tree.
. tests/house/runner/library.sh
once submissions "what is a submission"
needs submissions 'submissions' python3
python3 -B tests/grade/check submissions test_names test_submissions test_exports test_folders \
    test_archives test_nested test_broken_archives test_policy test_crew \
    test_attack_cases test_run_tests test_waiting test_judge_report
