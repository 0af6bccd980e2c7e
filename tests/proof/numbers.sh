#!/bin/sh
# numbers.sh - numbers as they are read against the C library's, ten million (tests/proof/exact/numbers.c); by
# another compiler or with a sanitizer (BRIEF) one million.
# Only reads the tree.
"$BUILD/tests/proof/exact/numbers" "$([ -n "${BRIEF:-}" ] && echo 150000 || echo 1500000)"
