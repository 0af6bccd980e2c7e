#!/bin/sh
# hostile.sh - attacks on the grader: a few that change nothing where they succeed, on the tree as it is. hostile.sh all:
# all of them, on a tree full of secrets and in every sandbox that there is.
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once hostile "attacks on the grader"
needs_grading hostile 'attacks on the grader'
[ $# -gt 0 ] || set -- bubblewrap exit-in-constructor exit-in-function \
    forged-answer-early include-solution incbin-reference circle-of-two wait-for-blanks wait-object lend-no- \
    reference- table chance- honest-counting honest-latin honest-output honest-pragma honest-printf \
    honest-sorting honest-wait honest-wrong unset-
if [ "$1" = all ]; then python3 -B tests/grade/attacks; else HERE=1 python3 -B tests/grade/attacks "$@"; fi
