#!/bin/sh
# labels.sh - labels of figures never collide: 1000 random ordinary cameras, rays, scenes or wrong answers of each
# figure (fewer with LABELS), in both shapes, read from the SVG.
# Only reads the tree.
set -u
. tests/house/runner/library.sh

once labels "labels of hundreds of figures"
needs 'labels' 'labels of figures' gnuplot python3

export PROGRAMS WRONG_FIGURE="$BUILD/tests/proof/wrong_figure" PYTHONPATH=tests/house/figures
# Figures whose labels are placed by the rule, and all marks are known to it.
figures='camera-frame corner-vectors point-30-10 double-dwh camera-forms object-order image-order ray-casting
    nearest-hit explain ray-sphere parabola discriminant world-object screen-to-unit pixel-grid pixel-to-ray
    yours-and-right wrong:all'
# shellcheck disable=SC2086 # names are words
counted python3 tests/house/figures/ordinary.py "${LABELS:-1000}" $figures
finish 'labels'
