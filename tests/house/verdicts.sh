#!/bin/sh
# verdicts.sh - a verdict belongs to the text that was judged: after a watch, after a run that was
# ended, with two runs at once, and when a text is saved while watch starts.
# Builds only below its answers.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once verdicts "verdicts and what was judged"

answers=$scratch/answers
export NO_COLOR=1
course() {
    make --no-print-directory "$@" ANSWERS="$answers" >"$scratch/said" 2>&1
}
fresh() {
    rm -rf "$answers" "build$answers"
    mkdir "$answers"
    cp solutions/*.c "$answers"
}
blank() {
    cp "build/blanks/$1.c" "$answers"
}
# A program in the list of processes that has these words, which begin with 'build'.
is_running() {
    grep -lz -- "[b]${1#b}" /proc/[0-9]*/cmdline 2>/dev/null | grep -q .
}

# Watch judges a right answer; then the blank is put back while nobody watches; and the other way.
watched() {
    start make --no-print-directory watch EX=01 ANSWERS="$answers" >"$scratch/watched" 2>&1
    wait_until grep -q Watching "$scratch/watched"
}
# No process of the group but those that have ended and whose parent has not asked.
none_is_left() {
    ! cat /proc/[0-9]*/stat 2>/dev/null |
        awk -v group="$group" '{ sub(/.*\) /, "") } $1 != "Z" && $3 == group { found = 1 } END { exit !found }'
}
fresh
blank 01-corners
check 'watch starts with a blank' watched
# As many editors save: another file takes the name.
cp solutions/01-corners.c "$scratch/new" && mv "$scratch/new" "$answers/01-corners.c"
check 'and sees the answer' wait_until grep -q '01-corners is right' "$scratch/watched"
group=${started# }
end_started
check 'nothing that it started is left' wait_until none_is_left
blank 01-corners
course exercises EX=01
check 'after watch, a blank is not called right' says 'upper_left  is not answered yet'
check 'watch starts again' watched
end_started
cp solutions/01-corners.c "$answers"
course exercises EX=01
check 'nor is a right answer called blank' says '01-corners is right'

# Ended in the middle of an endless loop, by a signal to all that make has started, and by kill -9. The answer says itself
# that it is at work: on a busy machine nobody may look while it is.
ended() {
    fresh
    course exercises EX=03
    rm -f "$scratch/at-work"
    sed "s|#include \"common/answers.h\"|&\n#include <stdio.h>|
        s|return (Normalized){point.x|fopen(\"$scratch/at-work\", \"w\");\n    for (volatile int i = 0; i < 1; i *= 2);\n    &|" \
        solutions/03-screen.c >"$answers/03-screen.c"
    start make --no-print-directory exercises EX=03 ANSWERS="$answers" >/dev/null 2>&1
    group=${started##* }
    wait_until test -e "$scratch/at-work" || return 1
    kill -s "$1" -- "-$group"
    wait "$group" 2>/dev/null
    wait_until nothing_runs
}
nothing_runs() {
    ! is_running "build$answers/verdict"
}
for signal in TERM HUP KILL; do
    check "a run is ended by SIG$signal" ended $signal
    course exercises EX=03
    check "the next one says what is wrong" says 'was still running after 1 s (an endless loop?)'
    cp solutions/03-screen.c "$answers"
    course exercises EX=03
    check "and a right answer is right again" says '03-screen is right'
done

# Two at once.
two_at_once() {
    fresh
    blank 07-shading
    course exercises ANSWERS="$answers" >/dev/null
    for file in "$answers"/*.c; do
        echo >>"$file"
    done
    for run in 1 2; do
        start make --no-print-directory exercises ANSWERS="$answers" >"$scratch/run$run" 2>&1
    done
    for group in $started; do
        wait "$group" || status=1
    done
    started=""
    cat "$scratch/run1" "$scratch/run2"
    [ "$(grep -c ' done$' "$scratch/run1")" -eq 7 ] && [ "$(grep -c ' done$' "$scratch/run2")" -eq 7 ]
}
check 'two runs at once say the same' two_at_once

# Whoever comes later waits, and judges then.
waits_for_the_lock() {
    fresh
    course exercises EX=03
    start flock "build$answers/verdict/lock" sleep 600
    wait_until is_locked
    sed 's/1 - point.y/point.y/' solutions/03-screen.c >"$answers/03-screen.c"
    holder=$started
    start make --no-print-directory exercises EX=03 ANSWERS="$answers" >"$scratch/waited" 2>&1
    wait_until grep 'waiting until that is done' "$scratch/waited" && ! grep 'looks like' "$scratch/waited" &&
        kill -- "-${holder# }" && wait_until grep 'looks like' "$scratch/waited"
    status=$?
    end_started
    return $status
}
is_locked() {
    ! flock -n "build$answers/verdict/lock" true
}
check 'a run waits for another in the same folder' waits_for_the_lock

# A save of what watch has just judged, before it has judged all for the first time, is also judged.
saved_early() {
    fresh
    start make --no-print-directory watch ANSWERS="$answers" >"$scratch/watched" 2>&1
    wait_until test -e "build$answers/verdict/04-pixel-ray/answer.o" || return 1
    sed 's/1 - point.y/point.y/' solutions/03-screen.c >"$answers/03-screen.c"
    wait_until grep -q 'looks like' "$scratch/watched"
    status=$?
    end_started
    return $status
}
check 'the first save after the start of watch is not lost' saved_early

# A terminal that is closed ends it, also if make was killed alone.
ends_with_make() {
    fresh
    watched
    group=${started##* }
    kill -KILL "$group"
    wait_until no_watch
}
no_watch() {
    ! is_running "build$answers/verdict/plan"
}
check 'watch ends if make is gone' ends_with_make
end_started

# A verdict is not an error of make; a script asks for the status.
fresh
sed 's/1 - point.y/point.y/' solutions/03-screen.c >"$answers/03-screen.c"
check 'a wrong answer is not an error of make' make --no-print-directory exercises EX=03 ANSWERS="$answers"
check 'make status says nothing else of right answers' make -s status EX=01 ANSWERS="$answers"
status_fails() {
    ! make -s status ANSWERS="$answers" "$@"
}
check 'and fails if an answer is wrong' status_fails EX=03
check 'or only one of several chapters' status_fails
# A path is longer, and stays in one piece.
fits_60_columns() {
    says 'looks like' && ! grep -v 'build/' "$scratch/said" | grep -nE '^.{60}' && ! grep -n ' $' "$scratch/said"
}
COLUMNS=60 course exercises EX=03
check 'lines are as wide as the terminal' fits_60_columns
# Each step is a command that a person can type.
fresh
shows_commands() {
    course exercises EX=01 V=1
    grep -E '^(cc|gcc|clang|build)' "$scratch/said" | sed '3q' >"$scratch/commands"
    grep -c '' "$scratch/commands" | grep -qx 3 && sed '3s/ >.*//' "$scratch/commands" | sh
}
check 'the three commands of a verdict can be typed' shows_commands
echo 'int main(void) { return 0; }' >>"$answers/01-corners.c"
course exercises EX=01
check 'a second main is the linker'\''s matter' says 'main'
check 'and not right' says_not '01-corners is right'
rm -rf "build$answers"
finish verdicts
