#!/bin/sh
# one_case.sh - CK_RUN_CASE=FUNCTION runs the tests of one function alone; a verdict is about all of them.
# Only reads the tree.
set -u
. tests/house/runner/library.sh

tests() {
    "$PROGRAMS/tests" 01-corners "$@"
}
tests --only upper_left >"$scratch/only"
CK_RUN_CASE=upper_left tests >"$scratch/case"
check 'CK_RUN_CASE=upper_left runs what --only upper_left runs' cmp "$scratch/only" "$scratch/case"
check 'and those are fewer than all' test "$(tests | tail -n 1)" != "$(tail -n 1 "$scratch/case")"
check 'and all of them pass' grep -q ', 0 failed$' "$scratch/case"
CK_RUN_CASE=nothing tests >"$scratch/none"
check 'the name of a missing function fails' test $? -eq 1

mkdir "$scratch/all" "$scratch/one"
"$BUILD/judge" 01-corners /bin/false "$scratch/all" >"$scratch/said" 2>&1
CK_RUN_CASE=upper_left "$BUILD/judge" 01-corners /bin/false "$scratch/one" >"$scratch/said" 2>&1
check 'a verdict has every function' cmp "$scratch/all/report" "$scratch/one/report"

finish one_case
