#!/bin/sh
# numbers.sh - numbers as they are read against the C library's, ten million (tests/proof/exact/numbers.c).
# Only reads the tree.
"$BUILD/tests/proof/exact/numbers" 1500000
