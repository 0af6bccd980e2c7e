#!/bin/sh
# verdicts.sh - a verdict belongs to the text that was judged: after a watch, after a run that was
# ended, with two runs at once, and when a text is saved while watch starts.
# Builds only below its answers.
set -u
. tests/house/runner/library.sh
ordinary verdicts "verdicts and what was judged"

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
state_is() {
    course status EX="$1"
    says "$2	$3"
}
# A program in the list of processes that has these words, which begin with 'build'.
is_running() {
    grep -lz -- "[b]${1#b}" /proc/[0-9]*/cmdline 2>/dev/null | grep -q .
}

# Watch judges a right answer; then the blank is put back while nobody watches; and the other way.
watched() {
    start env POLL="$1" make --no-print-directory watch EX=01 ANSWERS="$answers" >"$scratch/watched" 2>&1
    wait_until grep -q Watching "$scratch/watched"
}
fresh
blank 01-corners
check 'watch starts with a blank' watched ''
cp solutions/01-corners.c "$answers"
check 'and sees the answer' wait_until grep -q '01-corners is right' "$scratch/watched"
end_started
blank 01-corners
course exercises EX=01
check 'after watch, a blank is not called right' says 'upper_left  is not answered yet'
check 'watch starts again' watched ''
end_started
cp solutions/01-corners.c "$answers"
course exercises EX=01
check 'nor is a right answer called blank' says '01-corners is right'

# Ended in the middle of an endless loop, by a signal to all that make has started, and by kill -9.
ended() {
    fresh
    course exercises EX=03
    sed 's|return (Normalized){point.x|for (volatile int i = 0; i < 1; i *= 2);\n    &|' solutions/03-screen.c >"$answers/03-screen.c"
    start make --no-print-directory exercises EX=03 ANSWERS="$answers" >/dev/null 2>&1
    group=${started##* }
    wait_until is_running "build$answers/verdict/03-screen/answering" || return 1
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

# A save before watch has judged for the first time is also judged.
saved_early() {
    fresh
    start env POLL="$1" make --no-print-directory watch ANSWERS="$answers" >"$scratch/watched" 2>&1
    wait_until test -e "build$answers/verdict/01-corners/answer.o" || return 1
    sed 's/1 - point.y/point.y/' solutions/03-screen.c >"$answers/03-screen.c"
    wait_until grep -q 'looks like' "$scratch/watched"
    status=$?
    end_started
    return $status
}
check 'the first save after the start of watch is not lost' saved_early ''
check 'nor without events' saved_early 1

# A terminal that is closed ends it, also if make was killed alone.
ends_with_make() {
    fresh
    watched ''
    group=${started##* }
    kill -KILL "$group"
    wait_until no_watch
}
no_watch() {
    ! is_running "build$answers/verdict/plan"
}
check 'watch ends if make is gone' ends_with_make
end_started

# Whoever started this test may ignore SIGQUIT, and so would make.
wrong_answer() {
    fresh
    sed 's/1 - point.y/point.y/' solutions/03-screen.c >"$answers/03-screen.c"
    env "$1-signal=QUIT" make --no-print-directory exercises EX=03 ANSWERS="$answers" >"$scratch/said" 2>&1
    status=$?
    cat "$scratch/said"
    [ $status -ne 0 ] && says '03-screen  screen_to_normalized'
}
is_not_said_by_make() {
    wrong_answer --default && says_not 'make:'
}
if env --default-signal=QUIT true 2>/dev/null; then
    check 'a wrong answer is not an error of make, but the status is not 0' is_not_said_by_make
    check 'nor is it where make ignores the signal for that' wrong_answer --ignore
fi
# A path is longer, and stays in one piece.
fits_60_columns() {
    says 'looks like' && ! grep -v 'build/' "$scratch/said" | grep -nE '^.{60}' && ! grep -n ' $' "$scratch/said"
}
COLUMNS=60 course exercises EX=03
check 'lines are as wide as the terminal' fits_60_columns
lists_commands() {
    GDB_FLAGS=-batch course debug EX=03
    says 'n       the next line'
}
if command -v gdb >/dev/null; then
    check 'debug lists the commands of gdb' lists_commands
fi
# What makes a verdict come sooner is not seen in it. Answers are linked as shared objects, unless the linker
# would say something; and the compiler's words name the contract, not the precompiled one.
fresh
course exercises EX=01
if [ -e "build/answering/01-corners" ]; then
    check 'an ordinary answer is a shared object' test -e "build$answers/verdict/01-corners/answer.so"
fi
echo 'int main(void) { return 0; }' >>"$answers/01-corners.c"
course exercises EX=01
check 'a second main is the linker'\''s matter' says 'main'
check 'and not right' says_not '01-corners is right'
fresh
sed -i.bak 's/^vec3 upper_left(Camera c)/vec3 upper_left(Camera c, int d)/' "$answers/01-corners.c"
course exercises EX=01
check 'the contract is named' says 'exercises/01-corners.h'
check 'not the precompiled one' says_not 'precompiled'
# From the saved answer to its verdict; the time for its picture comes afterwards.
starts_few_programs() {
    fresh
    course exercises EX=01
    echo >>"$answers/01-corners.c"
    strace -f -e trace=execve -o "$scratch/traced" make --no-print-directory exercises EX=01 ANSWERS="$answers" \
        >"$scratch/said" 2>&1
    says '01-corners is right' || return 1
    count=$(grep 'execve(.* = 0$' "$scratch/traced" | sed '/--no-print-directory", "-s"/,$d' | wc -l)
    echo "$count programs"
    [ "$count" -le 20 ]
}
if command -v strace >/dev/null; then
    check 'a verdict takes at most 20 programs' starts_few_programs
else
    echo 'skipped: how many programs a verdict takes: strace is missing'
fi
rm -rf "build$answers"
finish verdicts
