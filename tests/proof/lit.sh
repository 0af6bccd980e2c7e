#!/bin/sh
# lit.sh - shadows and mirrors through the hierarchy, on many random scenes (tests/house/engines/lit.c).
# Only reads the tree.
"$BUILD/tests/house/engines/lit" 5000
