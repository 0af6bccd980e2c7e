#!/bin/sh
# figures.sh - what the figures show is so: each chapter's, by computations of their own.
#
# Needs gnuplot to draw and Python to read; CAMERAS says how many random ones are tried in each of
# chapters 01 to 04, SCENES how many rays or scenes in each of 05 and 06 (as many).
# Only reads the tree.
set -u
. tests/library.sh

needs figures 'figures' gnuplot python3
CAMERAS=${CAMERAS:-5}
export PROGRAMS CAMERAS SCENES="${SCENES:-$CAMERAS}"
# shellcheck disable=SC2016 # the inner shell expands them
printf '%s\n' tests/figures/[0-9]*.py | xargs -P "$(getconf _NPROCESSORS_ONLN)" -I '{}' \
    sh -c 'python3 "$1" >"$0/${1##*/}.log" 2>&1' "$scratch" '{}'
for test in tests/figures/[0-9]*.py; do
    counted cat "$scratch/${test##*/}.log"
done
finish figures
