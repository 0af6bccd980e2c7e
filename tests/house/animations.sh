#!/bin/sh
# animations.sh - what the animations show at each moment, by independent computations.
#
# SCENES says how many random scenes are tried (1). The videos are tested in tests/proof/animations.sh.
# Only reads the tree.
set -u
. tests/house/runner/library.sh
once animations "the animations"

needs animations 'the animations' gnuplot python3
export PROGRAMS SCENES="${SCENES:-1}"
export PYTHONPATH=tests/house/figures
counted python3 tests/house/figures/animations.py
finish animations
