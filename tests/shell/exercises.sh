#!/bin/sh
# exercises.sh - what 'make exercises' says of right, wrong and broken answers.
set -u
. tests/library.sh

answers=$scratch/answers
BUILD=build # whatever is under test: answers are judged by the ordinary build
export CK_DEFAULT_TIMEOUT=1

# Judges the folder of answers; what was said is in $scratch/said.
judge() {
    make --no-print-directory exercises ANSWERS="$answers" "$@" >"$scratch/said" 2>&1
}
says() {
    cat "$scratch/said"
    grep -qF -- "$1" "$scratch/said"
}
says_not() {
    cat "$scratch/said"
    ! grep -qF -- "$1" "$scratch/said"
}
first_line_says() {
    cat "$scratch/said"
    head -n 1 "$scratch/said" | grep -qF -- "$1"
}
fits_80_columns() {
    ! grep -nE '^.{81}' "$scratch/said" && ! grep -n ' $' "$scratch/said"
}
# A chapter with the solution's answers, but for one line: the sed command.
answer() {
    sed "$2" "solutions/$1.c" >"$answers/$1.c"
}
fresh() {
    rm -rf "$answers"
    mkdir -p "$answers"
}

fresh
judge EX=01
check 'a blank is not answered yet' first_line_says '01-corners  upper_left  is not answered yet'
check 'and not called wrong' says_not 'wrong'
check 'what comes next is said' says 'Next: '

fresh
answer 01-corners 's|c.width / 2 \* c.right|c.width * c.right|g; s|#include "common/answers.h"|&\n#include <stdio.h>|; s|return c.distance \* c.forward - |printf("my d is %g\\n", c.distance);\n    &|'
judge EX=01
check 'the first wrong answer is at the top' first_line_says '01-corners  upper_left  is wrong:'
check 'what went in is shown' says 'eye (2, 2, -4)'
check 'what was expected is shown' says 'expected   (-1, 1, 4)'
check 'what came out is shown' says 'yours      (-2, 1, 4)'
check 'what the student printed is shown' says 'it printed my d is 4'
check 'what is right is counted' says '3 of 5'
check 'all fits in 80 columns' fits_80_columns

fresh
answer 01-corners 's|return image_plane_vector(c, 0.3, 0.1)|return image_plane_vector(c, 0.3, 0.1) * 1|; s|(s - 0.5)|s|'
judge EX=01
check 'an answer that fails by another only waits' says 'waiting: across_30_up_10 (for image_plane_vector)'
check 'the other one is what is wrong' first_line_says 'image_plane_vector  is wrong'

fresh
answer 01-corners ''
echo 'this is no C' >"$answers/05-quadratic.c"
judge EX=05
check 'a compile error is said, with the file' says "$answers/05-quadratic.c:"
judge
check 'a compile error in chapter 05 does not hide chapter 01' says '01-corners      5 of 5 right'
check 'the first trouble is the top, not the worst' first_line_says '02-cameras'

fresh
answer 03-screen 's|return (Normalized){point.x|*(volatile int *)0 = 1;\n    &|'
judge EX=03
check 'a crash is said in words' says 'crashed (Segmentation fault)'
check 'and its input is shown' says 'screen'

fresh
answer 03-screen 's|return (Normalized){point.x|for (volatile int i = 0; i < 1; i *= 2);\n    &|'
judge EX=03
check 'an endless loop is said in words' says 'still running'

fresh
answer 03-screen 's|#include "common/answers.h"|&\n#include <stdlib.h>|; s|return (Normalized){point.x|exit(0);\n    &|'
judge EX=03
check 'an exit is no pass' says 'ended the program by itself'

fresh
answer 03-screen 's|pixel_center|pixel_centre|'
judge EX=03
check 'a function that is not there is named' says 'pixel_center is not in this file'

fresh
for solution in solutions/*.c; do
    cp "$solution" "$answers"
done
judge
check 'the solutions are all right' says 'All right, every chapter.'
check 'and the exit status says so' judge

rm -rf "${BUILD:?}$answers"
finish exercises
