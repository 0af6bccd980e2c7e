#!/bin/sh
# explained.sh - what a student reads where an answer does not compile, by any compiler, $CC (explained.txt).
# Only reads the tree.
if [ -z "${TRANSCRIPT:-}" ]; then
    . tests/house/runner/library.sh
    ordinary explained "the compiler's words"
    exec python3 -B tests/house/runner/transcript.py tests/house/explained.txt
fi

# The functions of the text.
cc=${CC:-cc}
work=$(mktemp -d) || exit
trap 'rm -rf "$work"' EXIT
# shellcheck disable=SC2153 # transcript.py sets HERE
flags="-std=c11 -D_DEFAULT_SOURCE -ffp-contract=off -Wno-psabi -I.
    $(sed -n '/^FOR_STUDENTS := /,/[^\]$/{ s/^FOR_STUDENTS := //; s/\\$//; p; }' "$HERE/Makefile")"
# What is said of a chapter's answer, which is in standard input. Fails if it is not about the answer alone, or is wider
# than a terminal.
compiled() { # STEM
    answer=$work/$1.c
    cat >"$answer"
    # shellcheck disable=SC2086 # the compiler and its flags are words
    (cd "$HERE" && LC_ALL=C $cc $flags -c -o "$work/answer.o" "$answer" 2>"$work/words")
    said
}
said() {
    (cd "$HERE" && "$BUILD/explain" "$answer" <"$work/words" >"$work/said")
    messages=$(grep -cE "^$answer:[0-9:]+ (fatal )?(error|warning):" "$work/said")
    sed "s|$work/||" "$work/said"
    ! { grep -E '^[^ |]+:[0-9]+:' "$work/said" | grep -vF "$answer:"; } &&
        ! grep -E '^In file|^ +from |^cc1|: In function|generated\.$|terminated' "$work/said" &&
        ! grep -E '^.{80}| $' "$work/said" && ! LC_ALL=C grep '[^ -~]' "$work/said"
}
# The solution of a chapter, but for a line that a sed command breaks: all that is said, and how many messages that are.
broken() { # STEM SED
    sed "$2" "$HERE/solutions/$1.c" | { compiled "$1" && echo "$messages messages"; }
}
# What helps, each in a line, of a mistake of which there is one message, and that an error.
explain() { # STEM SED
    sed "$2" "$HERE/solutions/$1.c" | helped "$1"
}
helped() { # STEM
    if ! compiled "$1" >"$work/all" || [ "$messages" -ne 1 ] || ! head -n 1 "$work/said" | grep -q ' error:'; then
        cat "$work/all"
    fi
    sed -n '/^  help: /,/^[^ ]/{ /^   *[^ |]/p; }' "$work/said" | tr -s '\n ' '  ' | sed 's/^ help: //; s/ help: /\n/g; s/ $//'
    echo
}
