#!/bin/sh
# same_shading.sh - shadows and mirrors through the hierarchy, on many random scenes (tests/house/engines/same_shading.c);
# on fewer by another compiler or with a sanitizer (BRIEF).
# Only reads the tree.
"$BUILD/tests/house/engines/same_shading" "$([ -n "${BRIEF:-}" ] && echo 1000 || echo 5000)"
