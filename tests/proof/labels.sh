#!/bin/sh
# labels.sh - labels of figures never collide: 1000 random ordinary cameras, rays or scenes of each figure (fewer with
# LABELS), in both shapes, read from the SVG.
# Only reads the tree.
set -u
. tests/house/runner/library.sh

once labels "labels of hundreds of figures"
needs 'labels' 'labels of figures' gnuplot python3

export PROGRAMS PYTHONPATH=tests/house/figures
counted python3 tests/house/figures/ordinary.py "${LABELS:-1000}"
finish 'labels'
