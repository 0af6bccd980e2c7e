#!/bin/sh
# submission.sh - 'make submission': what it packs, what it says, and that the grader reads it.
# Only reads the tree.
. tests/house/runner/library.sh
needs submission "'make submission'" python3
PACK=${BUILD:-build}/tests/course/submission/pack exec python3 -B tests/grade/check submission test_pack
