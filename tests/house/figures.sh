#!/bin/sh
# figures.sh - figures are right: of each chapter and of animations, by independent computations; of known mistakes and
# wrong answers.
#
# figures.sh random: only those of which there can be more. CAMERAS says how many random ones are tried in each of
# chapters 01 to 04, SCENES how many rays or scenes in each of 05 and 06 (as many), MISTAKES which known mistakes (every
# 100th).
# Builds only below its answers.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once figures "figures"

needs figures 'figures' gnuplot python3
CAMERAS=${CAMERAS:-3}
export PROGRAMS CAMERAS SCENES="${SCENES:-$CAMERAS}" NO_COLOR=1 PYTHONPATH=tests/house/figures
unset ANSWERS
{
    [ "${1:-}" = random ] || cat <<TESTS
tests/house/figures/wrong_answers.py $scratch/python
tests/house/figures/animations.py
tests/house/figures/words.py
tests/house/figures/colors.py
TESTS
    printf '%s\n' tests/house/figures/mistaken.py tests/[0-9]*/figures.py
} | nl >"$scratch/tests"
# shellcheck disable=SC2016 # the inner shell expands them
xargs -P "$(getconf _NPROCESSORS_ONLN)" -L 1 sh -c 'log=$0-$1; shift; python3 -B "$@" >"$log" 2>&1' \
    "$scratch/log" <"$scratch/tests"
for log in "$scratch"/log-*; do
    counted cat "$log"
done
finish figures
