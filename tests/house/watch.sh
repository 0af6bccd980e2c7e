#!/bin/sh
# watch.sh - 'make watch' judges what is saved, by inotify and by polling.
# Builds only below its answers.
set -u
. tests/house/runner/library.sh
ordinary watch "watching"

answers=$scratch/answers
export NO_COLOR=1

# Saves a wrong answer while watch runs, and waits until it says so.
judges_what_is_saved() {
    rm -rf "$answers"
    mkdir "$answers"
    cp solutions/*.c "$answers"
    start env POLL="$1" make --no-print-directory watch EX=03 ANSWERS="$answers" >"$scratch/said" 2>&1
    group=$!
    wait_until grep -q 'Watching' "$scratch/said" && sed 's/1 - point.y/point.y/' solutions/03-screen.c >"$scratch/new" &&
        mv "$scratch/new" "$answers/03-screen.c" && wait_until grep -q 'looks like' "$scratch/said"
    status=$?
    end_started
    cat "$scratch/said"
    return $status
}
# No process of the group but those that have ended and whose parent has not asked.
none_is_left() {
    ! cat /proc/[0-9]*/stat 2>/dev/null |
        awk -v group="$group" '{ sub(/.*\) /, "") } $1 != "Z" && $3 == group { found = 1 } END { exit !found }'
}

check 'a saved answer is judged, found by polling' judges_what_is_saved 1
check 'and nothing that was started is left' wait_until none_is_left
if [ "$(uname)" = Linux ]; then
    check 'a saved answer is judged, found by inotify' judges_what_is_saved ''
    check 'and nothing that was started for it is left' wait_until none_is_left
else
    echo 'skipped: watch by inotify, which is of Linux'
fi
rm -rf "build$answers"
finish watch
