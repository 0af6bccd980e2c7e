#!/bin/sh
# summary.sh - what 'make check' ends with: what was not tested and how it would be, then the sum, alone.
# Only reads the tree.
set -u
. tests/library.sh

# A program that says these lines: says_this NAME LINE...
says_this() {
    program=$scratch/$1
    shift
    { echo '#!/bin/sh' && printf "echo '%s'\n" "$@"; } >"$program" && chmod +x "$program"
}
says_this whole 'whole: 3 passed, 0 failed'
says_this part "skipped: a picture: gnuplot is missing (make setup installs it)" 'part: 2 passed, 0 failed'
says_this wrong 'not ok: a sentence' 'wrong: 1 passed, 1 failed'
ends_with() {
    wanted=$1
    shift
    .make/check "$scratch/log" "$@" >"$scratch/said" 2>&1
    cat "$scratch/said"
    [ "$(tail -n "$(echo "$wanted" | wc -l)" "$scratch/said")" = "$wanted" ]
}
check 'the sum is the last line' ends_with '3 passed, 0 failed' "$scratch/whole"
check 'nothing is said to be untested then' says_not 'Not tested'
check 'what was skipped is said just before it' ends_with 'Not tested here:
  a picture: gnuplot is missing (make setup installs it)
6 passed, 1 failed' "$scratch/part" "$scratch/whole" "$scratch/wrong"
finish summary
