#!/bin/sh
# hostile.sh - a class of attacks on the grader, in every sandbox that there is.
if [ -n "${BRIEF:-}" ]; then
    echo "skipped: attacks in every sandbox (BRIEF)"
    echo "hostile: 0 passed, 0 failed"
    exit 0
fi
if [ -z "$KIT" ]; then
    echo "skipped: attacks on the grader (see grading)"
    echo "hostile: 0 passed, 0 failed"
    exit 0
fi
python3 -B tests/grade/attacks
