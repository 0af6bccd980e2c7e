#!/bin/sh
# seeds.sh - the effect of SEED: other inputs for each, the same for the same, and none is shown.
# Builds only below its answers.
set -u
. tests/house/runner/library.sh

answers=$scratch/answers
folder=$scratch/verdict
mkdir "$answers" "$folder"

# ---- what is a seed -----------------------------------------------------------------------------

refuses_seed() {
    SEED=$1 "$BUILD/judge" 01-corners /bin/false "$folder" 2>"$scratch/said"
    [ $? -eq 2 ] || return 1
    SEED=$1 "$PROGRAMS/tests" 01-corners 2>>"$scratch/said"
    [ $? -eq 2 ] || return 1
    cat "$scratch/said"
    [ "$(grep -c 'expected a whole number from 0 to 9223372036854775807' "$scratch/said")" -eq 2 ]
}
for seed in '' x 1x -1 +1 ' 1' '1 ' 0x10 1.5 1e3 9223372036854775808 99999999999999999999; do
    check "SEED='$seed' is refused" refuses_seed "$seed"
done
for seed in 0 1 0042 9223372036854775807; do
    check "SEED=$seed is a seed" env SEED=$seed "$PROGRAMS/tests" 01-corners
done

# ---- marks do not depend on it ------------------------------------------------------------------

# (In check-all that test runs by itself, with more seeds.)
[ -n "${LONG:-}" ] || check 'with other seeds right answers pass and mistakes are named' \
    env SEEDS=1 FIRST=4711 tests/proof/seeds.sh

ordinary seeds "what a seed does to a report"

# ---- which inputs it makes ----------------------------------------------------------------------

# The solution, saying on stderr what it is asked.
sed 's|#include "common/answers.h"|&\n#include <stdio.h>|
    /^vec3 upper_left/,/^}/s|// BEGIN SOLUTION|&\n    fprintf(stderr, "%.17g %.17g\\n", c.distance, c.origin[0]);|' \
    solutions/01-corners.c >"$answers/01-corners.c"
talking=build$answers/tests # by the ordinary build
check 'an answer that says what it is asked is built' \
    make --no-print-directory ANSWERS="$answers" "$talking"
asked() {
    file=$1
    shift
    env "$@" 2>"$scratch/$file" >/dev/null
}
asked public "$talking" 01-corners
asked one SEED=1 "$talking" 01-corners
asked again SEED=1 "$talking" 01-corners
asked only SEED=1 "$talking" 01-corners --only upper_left
asked single SEED=1 "$talking" 01-corners --test the_corners_do_not_depend_on_where_the_eye_is
asked two SEED=2 "$talking" 01-corners
rm -rf "build$scratch"
differ() {
    [ -s "$scratch/$1" ] && [ -s "$scratch/$2" ] && ! cmp "$scratch/$1" "$scratch/$2"
}
# Its lines are some of those that all the tests together ask.
among_them() {
    [ -s "$scratch/single" ] && ! grep -vxFf "$scratch/one" "$scratch/single"
}
check 'the same seed makes the same inputs' cmp "$scratch/one" "$scratch/again"
check 'and for one function alone' cmp "$scratch/one" "$scratch/only"
check 'and for one test alone' among_them
check 'another seed makes other inputs' differ one two
check 'and none makes those that are public' differ one public

# ---- how they are reported ----------------------------------------------------------------------

# Chapter 01 with a first statement of its first answer, for other cameras than the public tests
# that come first: those are 4 and 6 away from their planes.
answer_that_does() {
    sed "s|#include \"common/answers.h\"|&\n#include <stdio.h>\n#include <stdlib.h>|
        /^vec3 upper_left/,/^}/s|// BEGIN SOLUTION|&\n    if (c.distance != 4 \&\& c.distance != 6) {\n$1\n}|" \
        solutions/01-corners.c >"$answers/01-corners.c"
    shift
    judge "$@"
}
judge() {
    env "$@" make --no-print-directory exercises ANSWERS="$answers" EX=01 >"$scratch/said" 2>&1
    rm -rf "build$scratch"
}
tells_no_number() {
    cat "$scratch/said"
    grep -q '^  given      random numbers of this run, not shown$' "$scratch/said" &&
        ! sed '/^  01-corners /,$d' "$scratch/said" | grep -E '[0-9]{3}|status|expected|yours|printed|camera  '
}
unknown='printf(\"%.17g\\n\", c.distance); return 7.25 * c.distance * c.right + c.origin;'
answer_that_does "$unknown"
check 'without a seed inputs are shown' says '  camera  '
check 'and what was expected' says '  expected  '
check 'and what came' says '  yours  '
check 'and what was printed' says '  it printed '
answer_that_does "$unknown" SEED=1
check 'with a seed the failed test is named' says 'the corners do not depend on where the eye is'
check 'and no number of it is shown' tells_no_number
answer_that_does 'return c.origin * *(volatile char *)(size_t)(1e6 * c.distance);' SEED=1
check 'a crash is reported' says 'crashed: read of an invalid address'
check 'but not of which address' tells_no_number
answer_that_does 'exit((int)(40 * c.distance));' SEED=1
check 'an exit is reported' says '  it         ended the program by itself'
check 'but not with which status' tells_no_number

sed '/^Camera with_unit_distance/,/^}/s|// BEGIN SOLUTION|&\n    if (c.distance <= 1) {\n        return c;\n    }|' \
    solutions/01-corners.c >"$answers/01-corners.c"
judge SEED=1
check 'a mistake that shows in a hidden test is named' says '  looks like '
check 'and its numbers are not' tells_no_number

finish seeds
