#!/bin/sh
# composed.sh - a mistake of one function, seen through another function of its chapter, has no other name.
# Only reads the tree.
set -u
. tests/house/runner/library.sh
once composed "mistakes seen through other functions"

for contract in exercises/*.h; do
    stem=$(basename "$contract" .h)
    check "a mistake of another function is not misnamed ($stem)" "$BUILD/tests/matrix" "$stem" --composed
done
finish composed
