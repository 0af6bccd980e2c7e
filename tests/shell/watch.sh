#!/bin/sh
# watch.sh - 'make watch' judges what is saved, by inotify and by polling.
set -u
. tests/library.sh

answers=$scratch/answers
export NO_COLOR=1

# Saves a wrong answer while watch runs, and waits (at most ten seconds) until it says so.
judges_what_is_saved() {
    rm -rf "$answers"
    mkdir "$answers"
    cp solutions/*.c "$answers"
    POLL=$1 make --no-print-directory watch EX=03 ANSWERS="$answers" >"$scratch/said" 2>&1 &
    wait_for 'Watching' && sed 's/1 - point.y/point.y/' solutions/03-screen.c >"$scratch/new" &&
        mv "$scratch/new" "$answers/03-screen.c" && wait_for 'looks like'
    status=$?
    pkill -f "$answers" # the loop, what it waits for, and make
    cat "$scratch/said"
    return $status
}
wait_for() {
    tries=0
    until grep -q "$1" "$scratch/said"; do
        tries=$((tries + 1))
        [ $tries -lt 100 ] || return 1
        sleep 0.1
    done
}

check 'a saved answer is judged, found by polling' judges_what_is_saved 1
if command -v inotifywait >/dev/null 2>&1; then
    check 'a saved answer is judged, found by inotify' judges_what_is_saved ''
else
    echo "skipped: watch by inotify: inotifywait is missing ('make setup' installs it)"
fi
rm -rf "build$answers"
finish watch
