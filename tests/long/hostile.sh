#!/bin/sh
# hostile.sh - a class of attacks on the grader, in every sandbox that there is.
exec python3 -B tests/grading/test_hostile.py
