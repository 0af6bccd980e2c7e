#!/bin/sh
# same_shading.sh - shadows and mirrors through the hierarchy, on many random scenes, and on 2,000 whose numbers are far
# apart (tests/house/engines/same_shading.c); on fewer by another compiler or with a sanitizer (BRIEF).
# Only reads the tree.
same=$BUILD/tests/house/engines/same_shading
if [ -z "${BRIEF:-}" ]; then
    "$same" 5000 1 2000
else
    "$same" 1000 1 200
fi
