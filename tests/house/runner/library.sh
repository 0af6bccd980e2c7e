# library.sh - for the tests that are shell scripts: one sentence, one verdict.
#
#     check 'a missing scene is refused' some_command with arguments
#     finish NAME
# shellcheck shell=sh
# A script also runs alone, from any folder, after 'make check' or 'make ready': sh tests/house/NAME.sh
# These are then those of the ordinary build.
: "${BUILD:=build}" "${ANSWERS:=solutions}" "${CC:=cc}" "${PROGRAMS:=$BUILD/$ANSWERS}"
: "${COMPILER:=$CC -std=c11 -D_DEFAULT_SOURCE -ffp-contract=off -Wno-psabi -I.}"
[ -n "${KIT+set}" ] || [ ! -e "$BUILD/grading/commands" ] || KIT=$BUILD/grading
export BUILD ANSWERS CC PROGRAMS COMPILER KIT="${KIT:-}"
passed=0
failed=0
here=$(pwd)
export PYTHONDONTWRITEBYTECODE=1 # nothing new in the tree
unset SEED # the public inputs, unless a test sets another SEED
scratch=$(mktemp -d) || exit 1
started=""
trap 'end_started; rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM

# Starts a command in the background, as a process group of its own, which ends with the test at the latest.
start() {
    setsid "$@" &
    started="$started $!"
}
# Ends what was started, by its id: the command, and all that it has started.
end_started() {
    for group in $started; do
        kill -- "-$group" 2>/dev/null || kill "$group" 2>/dev/null
        wait "$group" 2>/dev/null
    done
    started=""
}
# Waits until the command succeeds. The limit is there for what hangs, however busy the machine is.
wait_until() {
    tries=0
    until "$@" >/dev/null 2>&1; do
        tries=$((tries + 1))
        [ $tries -lt 1200 ] || return 1
        sleep 0.1
    done
}

# The sentence holds when the command succeeds; what it prints is shown when it does not.
check() {
    sentence=$1
    shift
    if "$@" >"$scratch/.output" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "not ok: $sentence"
        head -n 20 "$scratch/.output" | sed 's/^/    /'
    fi
}

# $scratch/said has the output of a command, for the tests that look for words in it.
says() {
    tail -n 20 "$scratch/said"
    grep -qF -- "$1" "$scratch/said"
}
says_not() {
    ! says "$1"
}

# links_lead_somewhere PAGE.md: each of its links is a file, or begins with http.
links_lead_somewhere() {
    folder=$(dirname "$1")
    status=0
    # shellcheck disable=SC2013,SC2016 # links have no blanks; Markdown's backquotes
    for link in $(sed 's/`[^`]*`//g' "$1" | grep -o '](\([^)#]*\)' | sed 's/^](//' | grep -v '^http'); do
        [ -e "$folder/$link" ] || { echo "$link"; status=1; }
    done
    return $status
}
# same_picture ONE.png OTHER.png ...: as tests/house/figures/png.py says
same_picture() {
    python3 "$here/tests/house/figures/png.py" "$@"
}

# Has the programs print the script of every figure into a folder, FOLDER/NAME/NAME.gp; their names are in
# 'names'.
scripts_into() {
    names=""
    for layout in chapters/*/figures/*.gp; do
        name=$(basename "$layout" .gp)
        names="$names $name"
        mkdir -p "$1/$name"
        "$PROGRAMS/$(basename "${layout%/figures/*}")" --figure "$name" >"$1/$name/$name.gp" || return 1
    done
}

# Runs a command where others are missing: without 'gnuplot fc-list' COMMAND...
without() {
    mkdir "$scratch/bin"
    for folder in $(echo "$PATH" | tr ':' ' '); do
        ln -s "$folder"/* "$scratch/bin" 2>/dev/null
    done
    for missing in $1; do
        rm -f "$scratch/bin/$missing"
    done
    shift
    path=$PATH
    PATH=$scratch/bin
    "$@"
    status=$?
    PATH=$path
    rm -rf "${scratch:?}/bin"
    return $status
}

# Runs another test, whose last line is that of 'finish', and adds what it has counted.
counted() {
    "$@" >"$scratch/.counted" 2>&1
    counts=$(sed -n '$s/.*: \([0-9]*\) passed, \([0-9]*\) failed$/\1 \2/p' "$scratch/.counted")
    if [ -n "$counts" ]; then
        sed '$d' "$scratch/.counted" | head -n 40
    else
        echo "not ok: '$*' did not come to its end"
        tail -n 5 "$scratch/.counted"
        counts="0 1"
    fi
    passed=$((passed + ${counts% *}))
    failed=$((failed + ${counts#* }))
}

finish() {
    echo "$1: $passed passed, $failed failed"
    [ "$failed" -eq 0 ]
}

# A test that needs the programs named: needs NAME 'what is not tested without them' PROGRAM...
needs() {
    needing=$1
    untested=$2
    shift 2
    for program_needed; do
        command -v "$program_needed" >/dev/null ||
            skip "$needing" "$untested: $program_needed is missing ('make setup' installs it)"
    done
}

# A test to which the compiler makes no difference, in a run for another one: once NAME 'what is not tested again'
once() {
    [ -z "${BRIEF:-}" ] || skip "$1" "$2: once is enough (BRIEF)"
}

# Ends a test that cannot run here, or need not: skip NAME 'what, and why'
skip() {
    echo "skipped: $2"
    finish "$1"
    exit
}
