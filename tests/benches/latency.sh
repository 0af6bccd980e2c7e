#!/bin/sh
# latency.sh - from saving an answer to reading its verdict, in milliseconds.
#
# 'make watch' runs on a copy of the solutions; each save changes one line of one chapter, in turn
# right and wrong. Between the saves, one bare 'cc -c' of the same file is timed, so that the ratio
# says what the loop adds on this machine, today. Usage: latency.sh [SAVES]
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
saves=${1:-60}
answers=$scratch/answers
mkdir "$answers"
cp solutions/*.c "$answers"
mkfifo "$scratch/said"
export NO_COLOR=1
unset MAKEFLAGS MAKELEVEL

# For both, or each end would wait to be opened until the other is.
exec 3<>"$scratch/said"
start make --no-print-directory watch ANSWERS="$answers" >&3 2>&1
trap 'end_started; rm -rf "$scratch" "build$answers"' EXIT

# The verdict is there when it says what is next, or that the chapter is right; the lines after it
# (the chapter's picture) are also read, but not timed.
until_said() {
    while IFS= read -r line <&3; do
        case $line in
        Next:* | *' is right. '*) return ;;
        esac
    done
}
until_shown() {
    while IFS= read -r line <&3; do
        case $line in
        Watching*) return ;;
        esac
    done
}
microseconds() {
    echo $(($(date +%s%N) / 1000))
}

until_shown
i=0
while [ $i -lt "$saves" ]; do
    for stem in 01-corners 03-screen 05-quadratic; do
        if [ $((i % 2)) -eq 0 ]; then
            sed "s/0\.5/0.25/; s/2 \* vec3_dot/vec3_dot/; \$a // $i" "solutions/$stem.c" >"$scratch/new"
        else
            sed "\$a // $i" "solutions/$stem.c" >"$scratch/new"
        fi
        from=$(microseconds)
        cp "$scratch/new" "$answers/$stem.c"
        until_said
        to=$(microseconds)
        until_shown
        echo $((to - from)) >>"$scratch/verdicts"
        from=$(microseconds)
        ${CC:-cc} -std=c11 -D_DEFAULT_SOURCE -Wno-psabi -I. -O1 -c -o "$scratch/bare.o" \
            "$answers/$stem.c"
        to=$(microseconds)
        echo $((to - from)) >>"$scratch/compiles"
    done
    i=$((i + 3))
done

percentile() { # HUNDREDTHS FILE: microseconds
    sort -n "$2" | sed -n "$(($1 * ($(wc -l <"$2") - 1) / 100 + 1))p"
}
ms() { # MICROSECONDS
    echo "$(($1 / 1000)).$(($1 / 100 % 10)) ms"
}
median=$(percentile 50 "$scratch/verdicts")
bare=$(percentile 50 "$scratch/compiles")
echo "save to verdict, $saves saves: median $(ms "$median"), 95th percentile $(ms "$(percentile 95 "$scratch/verdicts")")"
echo "one bare cc -c of the same file: median $(ms "$bare")"
echo "ratio of the medians: $((median / bare)).$((median * 10 / bare % 10))"
