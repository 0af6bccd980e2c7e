#!/bin/sh
# numbers.sh - numbers as they are read against the C library's, ten million (tests/exact/numbers.c).
# Only reads the tree.
"$BUILD/tests/exact/numbers" 1500000
