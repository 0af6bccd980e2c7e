#!/bin/sh
# reports.sh - what is written of a graded class, read back by others, with hostile names in it.
# Only reads the tree.
if ! command -v python3 >/dev/null 2>&1; then
    echo "skipped: reports (no python3; 'make setup FOR=instructor' installs it)"
    echo "reports: 0 passed, 0 failed"
    exit 0
fi
exec python3 -B tests/grading/check/run_tests.py reports test_comment test_report_formats test_report_tables \
    test_report_pages test_report_files
