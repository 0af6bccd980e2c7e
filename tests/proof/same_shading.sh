#!/bin/sh
# same_shading.sh - shadows and mirrors through the hierarchy, on many random scenes (tests/house/engines/same_shading.c).
# Only reads the tree.
"$BUILD/tests/house/engines/same_shading" 5000
