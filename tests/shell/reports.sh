#!/bin/sh
# reports.sh - what is written of a graded class, read back by others, with hostile names in it.
set -u

# Without python3 there is no grading, so there is nothing to skip.
if ! command -v python3 >/dev/null 2>&1; then
    echo "not ok: python3 is installed, which make grade needs (make setup FOR=contributor)"
    echo "reports: 0 passed, 1 failed"
    exit 1
fi
exec python3 -B tests/grading/test_reports.py
