#!/bin/sh
# mutants.sh - are the tests strict? One slip at a time in a solution: some test must fail.
#
# Every line between BEGIN SOLUTION and END SOLUTION is taken once for each sign, factor, operand,
# comparison and index in it, with that one changed. A mutant that passes all tests of its stem,
# graded and extra, has survived: the tests have a hole, or the change changes nothing that the
# contract promises. The latter are listed, with the reason, in tests/proof/equivalent-mutants.
set -u

# ---- one mutant: compiled, linked, tested -------------------------------------------------------

# Usage: mutants.sh --one FOLDER NUMBER. Says in FOLDER/results/NUMBER how it ended.
if [ "${1:-}" = --one ]; then
    folder=$2
    mutant=$folder/mutant-$3
    mkdir "$mutant"
    stem=$(sed -n "$3s/	.*//p" "$folder/mutants")
    "$MUTANTS" write "$folder/mutants" "$3" "$mutant/$stem.c"
    # shellcheck disable=SC2086 # the compiler's flags are words
    if $COMPILER $BOUNDS -O1 -g0 -w -c -o "$mutant/answer.o" "$mutant/$stem.c" &&
        sed "s|@|$mutant|g" "$folder/link-$stem" | sh; then
        # shellcheck disable=SC3045
        ulimit -c 0 2>/dev/null # where the shell can: no core files
        if timeout 10 "$mutant/tests"; then
            result=survived
        else
            result=killed
        fi
    else
        result=invalid
    fi >/dev/null 2>&1
    echo "$result" >"$folder/results/$3"
    rm -rf "$mutant"
    exit 0
fi

. tests/house/runner/library.sh
once mutants "slips in the solutions"
if [ "${BUILD:-build}" != build ]; then
    skip mutants "mutants: one compiler and the ordinary build tell enough"
fi
COMPILER=${COMPILER:-${CC:-cc} -std=c11 -D_DEFAULT_SOURCE -ffp-contract=off -Wno-psabi -I.}
# An index one too far is a crash, not luck.
BOUNDS="-fsanitize=bounds -fsanitize-undefined-trap-on-error"
# shellcheck disable=SC2086 # the compiler's flags are words
echo 'int f(void) { return 0; }' |
    $COMPILER $BOUNDS -x c -c -o "$scratch/bounds.o" - 2>/dev/null || BOUNDS=""
MUTANTS=build/tests/proof/mutants/mutants
export COMPILER BOUNDS MUTANTS CK_DEFAULT_TIMEOUT=2

# ---- everything that is not the mutant, once ----------------------------------------------------

# The command that links the tests of a stem, with @ for the folder of the mutant; then the reference
# takes the mutant's place.
prepare() {
    make --no-print-directory "objects-of-$1" >"$scratch/made" 2>&1 || {
        cat "$scratch/made"
        return 1
    }
    mkdir "$scratch/reference"
    echo "${CC:-cc} -o @/tests @/answer.o $(tail -n 1 "$scratch/made")" >"$scratch/link-$1"
    # shellcheck disable=SC2086 # the compiler's flags are words
    $COMPILER -c -o "$scratch/reference/answer.o" "solutions/$1.c" &&
        sed "s|@|$scratch/reference|g" "$scratch/link-$1" | sh && "$scratch/reference/tests"
    prepared=$?
    rm -r "$scratch/reference"
    return $prepared
}

mkdir "$scratch/results"
for solution in solutions/*.c; do
    stem=$(basename "$solution" .c)
    check "the solution of $stem passes its own tests" prepare "$stem"
    "$MUTANTS" list "$stem" >>"$scratch/mutants"
done
if [ "$failed" -ne 0 ]; then
    finish mutants
    exit 1
fi

sed -n = "$scratch/mutants" |
    xargs -n 1 -P "$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)" \
        "$0" --one "$scratch"
"$MUTANTS" sum "$scratch/mutants" "$scratch/results" tests/proof/equivalent-mutants
