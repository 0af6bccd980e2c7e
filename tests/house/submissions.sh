#!/bin/sh
# submissions.sh - what is a submission, what it is worth, and what is written of a graded class: modules of the grader;
# and what 'make submission' packs.
# Only reads the tree.
. tests/house/runner/library.sh
once submissions "what is a submission"
needs submissions 'submissions' python3
python3 -B tests/grade/check submissions test_submissions test_folders test_archives test_policy test_marking test_pack \
    test_reports test_class test_ledger test_return test_similar
