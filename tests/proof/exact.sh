#!/bin/sh
# exact.sh - the reference against exact arithmetic, on a million rays (tests/proof/exact/roots.c).
# Only reads the tree.
set -u
. tests/house/runner/library.sh
if ! printf '#include <gmp.h>\n' | $COMPILER -E - >/dev/null 2>&1; then
    skip exact "exact: GMP is missing ('make setup FOR=contributor' installs it)"
fi
# shellcheck disable=SC2086 # the compiler's flags are words
$COMPILER -o "$scratch/exact" tests/proof/exact/roots.c tests/proof/exact/exact.c tests/proof/exact/rays.c \
    solutions/05-quadratic.c common/answers.c -lgmp -lm || exit 1
"$scratch/exact"
