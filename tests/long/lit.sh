#!/bin/sh
# lit.sh - shadows and mirrors through the hierarchy, on many random scenes (tests/fast/lit.c).
# Only reads the tree.
"$BUILD/tests/fast/lit" 5000
