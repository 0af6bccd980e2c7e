#!/bin/sh
# optional.sh - the optional tasks: each solution draws its picture, each blank does not, and make says so.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once optional "the optional tasks"

tasks=$(basename -s .c solutions/optional/*.c)
optional() {
    make --no-print-directory optional "$@" >"$scratch/said" 2>&1
}
is_right() {
    optional ANSWERS=solutions TASK="$1" && says "$1: right"
}
# The reference's chapters, and no answer to the task: its blank is used.
answers=$scratch/answers
mkdir -p "$answers/optional" && cp solutions/*.c "$answers"
refused() { # TASK WORDS...
    ! optional ANSWERS="$answers" TASK="$1" || return 1
    shift
    for words; do
        says "$words" || return 1
    done
}
for task in $tasks; do
    check "the solution of $task draws its picture" is_right "$task"
    check "its blank draws none, and make names what is missing" refused "$task" "$task: needs " "exercises/optional/$task.c"
done

# One that is wrong: half the angle.
sed 's|degrees / 2 \* PI|degrees / 4 * PI|' solutions/optional/01-fisheye.c >"$answers/optional/01-fisheye.c"
says_how_wrong() {
    refused fisheye ' of 57600 pixels differ, by up to ' &&
        panels=$(sed -n 's/.*yours, expected, difference: //p' "$scratch/said") && [ -s "$panels" ]
}
check 'a wrong picture is counted, and shown beside the expected one' says_how_wrong
is_listed() {
    optional ANSWERS="$answers" && says 'pixels differ' && says 'not begun' &&
        [ "$(grep -c '^  [0-9]' "$scratch/said")" -eq "$(echo "$tasks" | wc -l)" ] &&
        ! grep '.\{81\}' "$scratch/said"
}
check 'the list has all tasks with their state' is_listed
printf 'this is not C\n' >"$answers/optional/01-fisheye.c"
check 'a task that does not compile is an error' refused fisheye 'error:'
sed 's|double radius = hypot(right, up), angle|double radius = *(volatile double *)16, angle|' \
    solutions/optional/01-fisheye.c >"$answers/optional/01-fisheye.c"
check 'a task that crashes has no picture' refused fisheye '01-fisheye: no picture: '
check 'an unknown task is refused' refused nothing 'TASK=nothing: no such task'
rm -rf "build/${answers:?}"

finish optional
