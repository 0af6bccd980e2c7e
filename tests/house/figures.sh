#!/bin/sh
# figures.sh - the figures of each chapter are right, by independent computations.
#
# Needs gnuplot to draw and Python to read; CAMERAS says how many random ones are tried in each of
# chapters 01 to 04, SCENES how many rays or scenes in each of 05 and 06 (as many).
# Only reads the tree.
set -u
. tests/house/runner/library.sh
once figures "the figures of each chapter"

needs figures 'figures' gnuplot python3
CAMERAS=${CAMERAS:-3}
export PROGRAMS CAMERAS SCENES="${SCENES:-$CAMERAS}"
export PYTHONPATH=tests/house/figures
tests='tests/house/figures/themes.py '$(echo tests/[0-9]*/figures.py)
# shellcheck disable=SC2016 # the inner shell expands them
echo "$tests" | tr ' ' '\n' | xargs -P "$(getconf _NPROCESSORS_ONLN)" -I '{}' \
    sh -c 'python3 "$1" >"$0/$(echo "$1" | tr / -).log" 2>&1' "$scratch" '{}'
for test in $tests; do
    counted cat "$scratch/$(echo "$test" | tr / -).log"
done
finish figures
