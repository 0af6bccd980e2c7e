# command_line.sh - for the tests of a program's command line: runs it, and says what came.
#
#     name=options
#     . tests/house/runner/command_line.sh
#     expect_exit 0 'a scene is cast' -o good.png good.nff
#     finish
#
# PROGRAMS is where 06-ray-casting is: build/solutions, unless told. They work in a folder of their
# own, in which good.nff is a scene.
# shellcheck shell=sh
LC_ALL=C
export LC_ALL
umask 022
# Seconds of work for each program, if the shell can set a limit: an endless loop must end.
# shellcheck disable=SC3045
ulimit -t 20 2> /dev/null

programs=${PROGRAMS:-build/solutions}
programs=$(cd "$programs" 2> /dev/null && pwd) || programs=${PROGRAMS:-build/solutions}
program=$programs/06-ray-casting
if [ ! -x "$program" ]; then
    echo "not ok: there is a program to test (no $program)"
    echo "$name: 0 passed, 1 failed"
    exit 1
fi

passed=0
failed=0
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
mkdir "$work/in" "$work/said"
cd "$work/in" || exit 1

# ---- checks -------------------------------------------------------------------------------------

# expect SENTENCE WHAT-CAME COMMAND...: the command succeeds.
expect() {
    sentence=$1
    came=$2
    shift 2
    if "$@" > /dev/null 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "not ok: $sentence ($came)"
    fi
}

# run ARGUMENTS...: the program, its words and its exit status.
run() {
    "$program" "$@" > "$work/said/out" 2> "$work/said/err" < /dev/null
    status=$?
    said="exit $status, said: $(head -c 300 "$work/said/err" | tr '\n' ' ')"
}

# Some line of stderr matches, all of it is plain text, and none is on stdout.
clean_error() {
    grep -E -q -e "$1" "$work/said/err" && [ ! -s "$work/said/out" ] &&
        [ "$(tr -d '\n -~' < "$work/said/err" | wc -c)" -eq 0 ]
}

ends() {
    [ "$status" -eq "$1" ] && clean_error "$2"
}

# expect_exit STATUS SENTENCE ARGUMENTS...: ends so, silently where 0, else with a reason.
expect_exit() {
    wanted=$1
    sentence=$2
    shift 2
    run "$@"
    if [ "$wanted" -eq 0 ]; then
        expect "$sentence" "$said" [ "$status" -eq 0 ]
    else
        expect "$sentence" "$said" ends "$wanted" .
    fi
}

# expect_says STATUS PATTERN SENTENCE ARGUMENTS...: ends so, with this on stderr.
expect_says() {
    wanted=$1
    pattern=$2
    sentence=$3
    shift 3
    run "$@"
    expect "$sentence" "$said" ends "$wanted" "$pattern"
}

# Wrong usage: the message has these words, and names --help.
expect_usage() {
    expect_says 2 "$@"
    expect "$2, and --help is named" "$said" clean_error "--help"
}

# expect_bad_file LINE WORDS SENTENCE: bad.nff is refused at this line, and no picture is made.
expect_bad_file() {
    rm -f bad.png
    expect_says 1 "^bad\.nff:$1: .*$2" "$3" -o bad.png bad.nff
    expect "$3, and no picture is made" 'there is one' [ ! -e bad.png ]
}

# expect_bad_scene LINE WORDS SENTENCE TEXT: the same of this text, as printf %b prints it.
expect_bad_scene() {
    printf '%b' "$4" > bad.nff
    expect_bad_file "$1" "$2" "$3"
}

# Width and height of a PNG, from its header: two numbers of four bytes from byte 16.
size_of() {
    od -A n -t u1 -j 16 -N 8 "$1" | awk '{ print ((($1 * 256 + $2) * 256 + $3) * 256 + $4) "x" \
        ((($5 * 256 + $6) * 256 + $7) * 256 + $8) }'
}

is_png() {
    [ "$(od -A n -t x1 -N 8 "$1" | tr -d ' \n')" = 89504e470d0a1a0a ]
}

# expect_picture WIDTHxHEIGHT FILE SENTENCE
expect_picture() {
    expect "$3" "$(size_of "$2" 2>&1)" is_png "$2"
    expect "$3, of $1" "$(size_of "$2" 2>&1)" [ "$(size_of "$2" 2> /dev/null)" = "$1" ]
}

same_file() {
    cmp -s "$1" "$2"
}

# A viewpoint, 6 lines.
view='v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nresolution 20 10\n'
printf '%b' "${view}s 0 0 0 1\n" > good.nff

# How many checks passed and failed.
finish() {
    echo "$name: $passed passed, $failed failed"
    [ "$failed" -eq 0 ]
}
