# answers.sh - for the transcripts that judge answers: a folder of answers, and what is done with it.
# shellcheck shell=sh
# Answers are judged by the ordinary build, whatever is under test.
# shellcheck disable=SC2153 # transcript.py sets HERE
. "$HERE/tests/house/runner/library.sh"
answers=$scratch/answers
# shellcheck disable=SC2034 # the text uses it
made=build$answers built=$HERE/build$answers # for make, and for others
trap 'rm -rf "$scratch" "$built"' EXIT
export NO_COLOR=1
unset PROGRAMS BUILD
course() { # MAKE'S ARGUMENTS...
    make -s -C "$HERE" --no-print-directory ANSWERS="$answers" "$@" >"$scratch/words" 2>&1
    status=$?
    sed "s|$scratch/||g" "$scratch/words"
    return $status
}
again() { # 'make exercises' of a chapter, without the time that make needs to find all of it built
    if [ -e "$built/verdict/plan" ]; then
        (cd "$HERE" && build/course exercises "$built/verdict/plan" "$1") >"$scratch/words" 2>&1
        status=$?
        sed "s|$scratch/||g" "$scratch/words"
        return $status
    else
        course exercises EX="${1%%-*}"
    fi
}
empty() {
    rm -rf "$answers" && mkdir -p "$answers"
}
fresh() {
    empty
    cp "$HERE/solutions/04-pixel-ray.c" "$answers" # a folder without any answer is refused
}
solved() {
    empty
    cp "$HERE"/solutions/*.c "$answers"
}
answer() { # STEM SED: the solution, but for what the sed command changes
    sed "$2" "$HERE/solutions/$1.c" >"$answers/$1.c"
}
judge() { # STEM SED: the verdict on that answer
    fresh
    answer "$1" "$2"
    again "$1"
}
does() { # STATEMENT HEADER: chapter 03 with a first statement of its first answer
    judge 03-screen "s|#include \"common/answers.h\"|&\n${2:-}|; s|return (Normalized){point.x|$1;\n    &|"
}
blank() { # STEM
    cp "$HERE/build/blanks/$1.c" "$answers"
}
line() { # WORDS STEM: the number of the first line with them
    grep -nF -m 1 -- "$1" "$answers/$2.c" | cut -d : -f 1
}
