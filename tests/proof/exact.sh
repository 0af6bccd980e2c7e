#!/bin/sh
# exact.sh - the reference against exact arithmetic, on random rays (tests/proof/exact.py).
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once exact 'exact arithmetic'
needs exact 'exact arithmetic' python3
# shellcheck disable=SC2086 # the compiler's flags are words
$COMPILER -o "$scratch/exact" tests/proof/exact.c tests/05-quadratic/exact.c -lm || exit 1
PYTHONPATH=tests/house/figures python3 tests/proof/exact.py "$scratch/exact"
