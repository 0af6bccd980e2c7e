#!/bin/sh
# composed.sh - a mistake of one function, seen through another function of its chapter, has no other name.
# Only reads the tree.
set -u
. tests/house/runner/library.sh
once composed "mistakes seen through other functions"

for matrix in "$BUILD"/tests/matrix/[0-9]*; do
    [ -x "$matrix" ] || continue
    check "a mistake of another function is not misnamed ($(basename "$matrix"))" "$matrix" --composed
done
finish composed
