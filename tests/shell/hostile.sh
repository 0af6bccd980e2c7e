#!/bin/sh
# hostile.sh - attacks on the grader that change nothing where they succeed, on the tree as it is. All of them,
# on a tree full of secrets and in every sandbox, are in tests/long/hostile.sh.
HERE=1 exec python3 -B tests/grading/test_hostile.py bubblewrap exit- forged-answer forged-wait forged-blank \
    forged-crash include- incbin- embed- assembler-include reference- circle- lend-itself table time- chance- \
    numbers- message- links- twice honest-
