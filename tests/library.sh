# library.sh - for the tests that are shell scripts: one sentence, one verdict.
#
#     check 'a missing scene is refused' some_command with arguments
#     finish NAME
# shellcheck shell=sh
passed=0
failed=0
here=$(pwd)
unset SEED # the public inputs, unless a test says otherwise
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT

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

finish() {
    echo "$1: $passed passed, $failed failed"
    [ "$failed" -eq 0 ]
}
