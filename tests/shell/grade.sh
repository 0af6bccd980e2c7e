#!/bin/sh
# grade.sh - 'make grade' on a small class, where it can be run.
if [ -z "$KIT" ]; then
    echo "skipped: grading ('make setup FOR=instructor' installs what it needs; no sanitizers)"
    echo "grading: 0 passed, 0 failed"
    exit 0
fi
exec python3 -B tests/grading/check/run_tests.py "grading, short" test_grade test_policy_change
