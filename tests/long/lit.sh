#!/bin/sh
# lit.sh - shadows and mirrors through the hierarchy, on many random scenes (tests/fast/lit.c).
"$BUILD/tests/fast/lit" 5000
