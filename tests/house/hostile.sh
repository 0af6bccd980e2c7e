#!/bin/sh
# hostile.sh - a few attacks on the grader that change nothing where they succeed, on the tree as it is.
# All of them, on a tree full of secrets and in every sandbox, are in tests/proof/hostile.sh.
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once hostile "attacks on the grader"
needs_grading hostile 'attacks on the grader'
HERE=1 python3 -B tests/grade/attacks bubblewrap exit-in-constructor exit-in-function \
    forged-answer-early include-solution incbin-reference circle-of-two wait-for-blanks wait-object lend-no- \
    reference- table chance- honest-counting honest-latin honest-output honest-pragma honest-printf \
    honest-sorting honest-wait honest-wrong unset-
