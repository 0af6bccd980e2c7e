#!/bin/sh
# grade.sh - a grader that is killed, shared, and started again gives the same marks.
if [ -z "$KIT" ]; then
    echo "skipped: grading, long"
    echo "grading: 0 passed, 0 failed"
    exit 0
fi
exec python3 -B tests/grading/check/run_tests.py "grading, long" test_regrade
