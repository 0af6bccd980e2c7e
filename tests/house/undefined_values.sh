#!/bin/sh
# undefined_values.sh - answers that use variables that were never set, or the fourth lane of a vec3: what happens to be
# in memory must not make them right on some days, or another function wrong (undefined_values.txt).
# Builds only below its answers.
if [ -z "${TRANSCRIPT:-}" ]; then
    . tests/house/runner/library.sh
    ordinary undefined_values "undefined values"
    exec python3 -B tests/house/runner/transcript.py tests/house/undefined_values.txt
fi

# The functions of the text.
# shellcheck disable=SC2153 # transcript.py sets HERE
. "$HERE/tests/house/judging.sh"
# STEM FUNCTION SED: this function is changed; the verdict, if it is wrong each time, and others only wait for it.
always() {
    empty
    sed "/^[A-Za-z].* $2(/,/^}/{ $3
    }" "$HERE/solutions/$1.c" >"$answers/$1.c"
    again "$1" | tee words
    grep -q "wrong: $2\$" words || return
    for run in 1 2 3 4 5; do
        rm -rf verdict && mkdir verdict
        JUDGE_TABLES=$HERE/build/tables "$HERE/build/judge" "$1" "$built/verdict/$1/answering" verdict >words 2>&1
        grep -B 1 '^state	[wc]r' verdict/report | head -n 1 | grep -q "	$2\$" || echo "run $run: another verdict"
    done
}
