#!/bin/sh
# exercises.sh - what 'make exercises' says of right, wrong and broken answers.
# Builds only below its answers.
set -u
. tests/house/runner/library.sh
ordinary exercises "what 'make exercises' says"

answers=$scratch/answers
BUILD=build # whatever is under test: answers are judged by the ordinary build
export NO_COLOR=1

# Judges the folder of answers; what was said is in $scratch/said.
judge() {
    exercises "$answers" "$@" >"$scratch/said" 2>&1
}
first_line_says() {
    cat "$scratch/said"
    head -n 1 "$scratch/said" | grep -qF -- "$1"
}
fits_80_columns() {
    ! grep -nE '^.{80}' "$scratch/said" && ! grep -n ' $' "$scratch/said"
}
# A chapter with the solution's answers, but for what the sed command changes.
answer() {
    sed "$2" "solutions/$1.c" >"$answers/$1.c"
}
fresh() {
    rm -rf "$answers"
    mkdir -p "$answers"
    cp solutions/04-pixel-ray.c "$answers" # a folder without any answer is refused
}
hint() {
    make --no-print-directory hint EX=01 ANSWERS="$answers" >"$scratch/said" 2>&1
}
# Chapter 03 with a first statement of its first answer, and headers.
answer_that_does() {
    fresh
    answer 03-screen "s|#include \"common/answers.h\"|&\n${2:-}|
        s|return (Normalized){point.x|$1;\n    &|"
    judge EX=03
}

fresh
judge # builds the judge, which make says: not what is looked at below
judge EX=01
check 'a blank is not answered yet' first_line_says '01-corners  upper_left  is not answered yet'
check 'its slide is named' first_line_says 'slide: Finding vectors from the eye'
check 'the question is shown' says 'Give an expression for the upper left corner.'
check 'a blank is not called wrong' says_not 'wrong'
check 'the next step is shown' says 'Next: '

fresh
answer 01-corners 's|c.width / 2 \* c.right + c.height / 2|c.width * c.right + c.height|; s|#include "common/answers.h"|&\n#include <stdio.h>|; s|return c.distance \* c.forward - |printf("my d is %g\\n", c.distance);\n    &|'
judge EX=01
check 'the first wrong answer is at the top' first_line_says '01-corners  upper_left'
check 'what went in is shown' says 'eye (2, 2, -4)'
check 'what was expected is shown' says 'expected   (-1, 1, 4)'
check 'what came out is shown' says 'yours      (-2, 2, 4)'
check 'the mistake is named' says 'looks like d f - w r + h u: '
check 'what the student printed is shown' says 'it printed my d is 4'
check 'only the first wrong answer is shown' says_not '(2, 2, 4)'
check 'what is right is counted' says '3 of 5'
check 'all fits in 80 columns' fits_80_columns
judge EX=01 ALL=1
check 'with ALL=1 every wrong answer is shown' says 'yours      (2, 2, 4)'

fresh
answer 01-corners 's|(s - 0.5)|7 * (s - 0.5)|'
judge EX=01
check 'what no known mistake explains still gets help from a law' says '  but '
check 'and is not called a mistake that it is not' says_not 'looks like'

fresh
answer 03-screen 's|1 - point.y|point.y|; s|#include "common/answers.h"|&\n#include <stdio.h>|; s|return (Normalized){point.x|puts("hello");\n    &|'
judge EX=03
check 'a mistake in one answer costs once, though tests of another call it' says '2 of 3'
fresh
answer 03-screen 's|pixel.row + 0.5|pixel.row|; s|#include "common/answers.h"|&\n#include <stdio.h>|; s|return (ScreenPoint){pixel|puts("hello");\n    &|'
judge EX=03
check 'what was printed is shown in whichever test fails' says 'it printed hello'
fresh
answer 05-quadratic '/^Roots quadratic_roots/,/^}/c Roots quadratic_roots(Quadratic q)\n{\n    double d = q.b * q.b - 4 * q.a * q.c;\n    if (d < 0)\n        return (Roots){0};\n    return (Roots){2, {(-q.b - sqrt(d)) / 2 * q.a, (-q.b + sqrt(d)) / 2 * q.a}};\n}'
judge EX=05
check 'a mistake is named though cases at the edge are not written yet' says 'C evaluates from left to right'
fresh
answer 03-screen 's|{point.x / screen.width, 1 - point.y|{point.x < 0 ? 0 : point.x / screen.width, point.y|'
judge EX=03
check 'of two mistakes the one that shows first is named' says 'looks like (x/W, y/H)'
check 'and it says that something else is also wrong' says 'Something else is also not right yet'
# 1/2 of both, and neither alone.
fresh
answer 01-corners 's|c.distance \* c.forward - c.width / 2|c.forward - c.width|'
judge EX=01
check 'of two mistakes in one formula both are named' says 'looks like d f - w r'
check 'the second after the first' says '  and also   f - w/2 r'
check 'two lines are enough, nothing else is claimed' says_not 'Something else'

fresh
answer 03-screen 's|return (Normalized){point.x.*|Normalized n;\n    n.s = point.x / screen.width;\n    return n;|'
judge EX=03
check 'a field that was never set is named' says 'but        t was never set'
fresh
answer 02-cameras 's|^CameraFault camera_from_points|static int calls;\n&|; s|return camera_from_vectors(eye, vectors, camera);|calls++;\n    CameraFault fault = camera_from_vectors(eye, vectors, camera);\n    camera->width *= calls;\n    return fault;|'
judge EX=02
check 'a state that is kept between calls is seen' says 'gives another result when it is called again'
# Memory past the end never looks right by luck: the answering process has filled it.
fresh
answer 06-ray-casting 's|i < scene->sphere_count; i++|i <= scene->sphere_count; i++|'
judge EX=06
check 'a sphere past the last one is seen' first_line_says '06-ray-casting  nearest_hit'
check 'and the loop is named' says 'looks like a loop up to i <= sphere_count'
fresh
answer 04-pixel-ray 's|return (Ray){camera.origin, \(.*\)};|vec3 v = \1;\n    return (Ray){vec3_of(0, 0, 0), v / vec3_length(v)};|'
judge EX=04
check 'a mistake is named though the length is another, which is free' says 'looks like'
check 'by itself' says_not 'Something else'

fresh
answer 02-cameras 's|return camera_from_vectors(eye, vectors, camera);|camera_from_vectors(eye, vectors, camera);|'
judge EX=02
check 'a forgotten return does not pass' says 'does not compile'
fresh
answer 01-corners 's|return c.distance|return return c.distance|'
hint
check 'what does not compile gets no hint, and the reason' says '01-corners has no verdict yet, so there is no hint'
fresh
answer 05-quadratic 's|i < roots.count|i <= roots.count|'
judge EX=05
check 'an index beyond the end does not pass' says 'went beyond the end of an array'

fresh
answer 01-corners 's|(s - 0.5)|s|'
judge EX=01
check 'an answer that fails by another only waits' says 'waiting: across_30_up_10 (for image_plane_vector)'
check 'the other one is what is wrong' first_line_says 'image_plane_vector'
fresh
answer 01-corners '/^vec3 upper_left/,/^}/s|return .*|return upper_right(c) - c.width * c.right;|; /^vec3 upper_right/,/^}/s|return .*|return upper_left(c) + c.width * c.right;|'
judge EX=01
check 'two that call each other are both wrong' says 'stack overflow'
check 'and neither waits for the other' says_not 'waiting'

fresh
answer 01-corners '/^vec3 upper_left/,/^}/s|return .*|return NOT_ANSWERED(vec3);|; /^Camera with/,/^}/s|= 1;|= 2;|'
judge EX=01
check 'a wrong answer is shown before one that is missing' first_line_says '01-corners  with_unit_distance'
hint
check 'and gets the hint' says 'with_unit_distance  hint 1 of'
fresh
answer 07-shading 's|0x1p-30|0x1p-20|; s|fmin(1, fmax(0, color.i.))|color[i]|'
judge EX=07
check 'of two wrong ones, the first in the file' first_line_says '07-shading  off_surface'

fresh
answer 01-corners ''
echo 'this is no C' >"$answers/05-quadratic.c"
judge EX=05
check 'a compile error is reported, with the file' says "$answers/05-quadratic.c:"
judge
check 'a compile error in chapter 05 does not hide chapter 01' says '01-corners       done'
check 'nor is it hidden' says '05-quadratic     does not compile'
check 'what is wrong comes before what is not answered yet' first_line_says '05-quadratic  does not compile'

answer_that_does '*(volatile int *)0 = 1'
check 'a write to nowhere is reported in words' says 'crashed: write to address 0'
check 'and what went in is shown' says 'screen     640 x 480'
answer_that_does 'printf("here\\n"); point.x = *(volatile double *)16' '#include <stdio.h>'
check 'a read from nowhere is reported in words' says 'crashed: read of address 0x10'
check 'and what was printed before it' says 'it printed here'
answer_that_does 'for (volatile int i = 0; i < 1; i *= 2);'
check 'an endless loop is reported in words' says 'was still running after 1 s (an endless loop?)'
answer_that_does 'exit(0)' '#include <stdlib.h>'
check 'an exit does not pass' says 'ended the program by itself (exit status 0)'
answer_that_does 'volatile int zero = 0; zero = 7 \/ zero'
check 'a division by zero is reported in words' says 'divided an integer by zero'
answer_that_does 'abort()' '#include <stdlib.h>'
check 'an abort is reported in words' says 'it was aborted'
answer_that_does 'volatile char big[10000]; big[0] = 1; if (point.x != 1e9) return screen_to_normalized((ScreenPoint){point.x + big[0], 0}, screen)'
check 'endless recursion is reported in words' says 'stack overflow'
answer_that_does 'for (;;) { volatile char *p = malloc(1 << 20); p[0] = 1; }' '#include <stdlib.h>'
check 'memory that runs out is reported in words' says 'ran out of memory'
answer_that_does 'close(4); for (;;) pause()' '#include <unistd.h>'
check 'a closed pipe is reported in words' says 'closed its pipe'
answer_that_does 'write(4, "all tests passed, full marks, honestly; and this is longer than any header would be, so that it is read as one.", 112)' '#include <unistd.h>'
check 'a forged answer is not an answer' says 'sent an invalid answer'
answer_that_does 'for (;;) puts("spam")' '#include <stdio.h>'
check 'a flood ends' says 'printed more than a million characters'
answer_that_does 'for (int i = 0; i < 9; i++) printf("%c[31mline %d\\n", 27, i)' '#include <stdio.h>'
check 'a right answer may print' says '03-screen is right'

# A helper that has the name of a helper of the tests: gdb starts all the same.
debugs() {
    env GDB_FLAGS=-batch make --no-print-directory debug EX=06 ANSWERS="$answers" >"$scratch/said" 2>&1
    says "$1"
}
fresh
answer 06-ray-casting 's|^Hit nearest_hit|char letter_of(int i);\nchar letter_of(int i)\n{\n    return (char)i;\n}\n\n&|; s|t < nearest.t|t > letter_of(0)|'
if command -v gdb >/dev/null; then
    check 'also for the debugger, a helper may have any name' debugs 'Breakpoint 2, nearest_hit'
fi

# ---- 1/2 and 0,5 --------------------------------------------------------------------------------

# Judges a chapter with a change, and looks for a sentence, which may be wrapped.
explains() {
    fresh
    answer "$2" "$3"
    judge EX="${2%%-*}"
    line=$(grep -nF -m 1 -- "$4" "$answers/$2.c" | cut -d : -f 1)
    check "$1" in_one_line "  help: in line $line, $5: C divides whole numbers without a remainder."
}
in_one_line() {
    cat "$scratch/said"
    grep -qF -- "$1" "$scratch/said"
}
explains '1/2 is explained' 01-corners \
    's|return image_plane_vector.*|return c.distance * c.forward + (0.3 - 1/2) * c.width * c.right + (0.1 - 1/2) * c.height * c.up;|' \
    '1/2' '1/2 is 0'
check 'once' [ "$(grep -c 'help: in line' "$scratch/said")" -eq 1 ]
check 'and fits' fits_80_columns
explains '3/10 in another place is explained' 01-corners 's|(c, 0.3, 0.1)|(c, 3/10, 0.1)|' '3/10' '3/10 is 0'
explains 'half a pixel' 03-screen 's|pixel.column + 0.5|pixel.column + 1 / 2|' '1 / 2' '1/2 is 0'
explains 'in a helper' 01-corners 's|^vec3 upper_left|static double half(double x) { return 1/2 * x; }\n&|; s|c.width / 2|half(c.width)|' '1/2' '1/2 is 0'
explains 'in a macro, and not only 0' 07-shading 's|^Color gamma_encode|#define POWER 3/2\n&|; s|1 / gamma|POWER|g' '3/2' '3/2 is 1'
fresh
answer 01-corners 's|c.width / 2|(double)1/2 * c.width * 1/2|'
judge EX=01
check 'another division is not called one' says_not 'whole numbers'
fresh
answer 01-corners 's|(c, 0.3, 0.1)|(c, 1/2, 0.1)|; s|c.height / 2|c.height * (1/2 + 0.5)|'
judge EX=01
check 'what is right is not corrected' says_not "in line $(grep -nF '(1/2 + 0.5)' "$answers/01-corners.c" | head -n 1 | cut -d : -f 1),"
fresh
answer 03-screen 's|pixel.row + 0.5|pixel.row + 0,5|'
judge EX=03
check 'a decimal comma is reported' says '  help: 0,5 is two numbers in C. If you mean one number, write 0.5.'
check 'and is not another mistake' says_not 'looks like'
check 'nor breaks another rule' says_not '  but '
fresh
answer 01-corners 's|(s - 0.5)|(s - 0,5)|'
judge EX=01
check 'a decimal comma in brackets is reported' says '  help: 0,5 is two numbers in C. If you mean one number, write 0.5.'
check 'and has no other name' says_not 'looks like'

# ---- a right answer also builds -----------------------------------------------------------------

fresh
answer 01-corners 's|^vec3 upper_left|double half(double x)\n{\n    return x / 2;\n}\n\n&|; s|c.width / 2|half(c.width)|'
answer 03-screen 's|^Normalized screen_to|double half(double x)\n{\n    return 1 - x / 2 - x / 2;\n}\n\n&|; s|1 - point.y / screen.height|half(point.y / screen.height)|'
judge
check 'two chapters may have helpers of one name' says '01-corners       done'
check 'and both are right' says '03-screen        done'
builds() {
    make --no-print-directory ANSWERS="$answers" "build$answers/03-screen"
}
check 'and the programs are built' builds

# Judges a chapter that must not be right: its first statement, or a change.
does_not_build() {
    fresh
    answer "$2" "$3"
    judge EX="${2%%-*}"
    check "$1: it is not right" says_not 'done'
    check "$1: the reason is reported" says "$4"
}
does_not_build 'a header that only another chapter includes' 01-corners \
    's|return c.distance \* c.forward - |printf("x");\n    &|' 'printf is in the standard library: #include <stdio.h>'
does_not_build 'its contract not included' 01-corners '/#include "exercises/d' \
    '#include "exercises/01-corners.h" is missing at the top'
does_not_build 'a main' 01-corners 's|^Camera with|int main(void)\n{\n    return 0;\n}\n\n&|' 'remove main'
does_not_build 'an inline that is nowhere else' 01-corners \
    's|^vec3 upper_left|inline double half(double x)\n{\n    return x / 2;\n}\n\n&|; s|c.width / 2|half(c.width)|' \
    'half is inline: write static inline'

fresh
answer 03-screen 's|pixel_center|pixel_centre|'
judge EX=03
check 'a function that is not there is named' says 'pixel_center is not in this file'

refused() {
    ! judge && says 'no answer in it'
}
rm -f "$answers"/*
check 'a folder without any answer is refused' refused

fresh
rm -f "build$answers"/verdict/*.rewarded
answer 01-corners ''
judge
check 'a chapter that has become right is rewarded, though others want work' says '01-corners is right.'
judge
check 'once' says_not '01-corners is right.'

fresh
hint
check 'the first hint is the first' says 'hint 1 of'
hint
check 'the second hint is another' says 'hint 2 of'
answer 01-corners 's|c.width / 2|c.width|'
hint
check 'after a change hints begin again' says 'hint 1 of'
fresh
answer 01-corners 's|(s - 0.5)|s|'
hint
check 'a hint is for what is wrong, not for what waits' says 'image_plane_vector  hint 1 of'

# For each picture that lacks an answer there is one line; the others are drawn.
fresh
for solution in solutions/*.c; do
    cp "$solution" "$answers"
done
cp build/blanks/07-shading.c "$answers"
gallery=build$answers/gallery
cast() {
    make --no-print-directory ANSWERS="$answers" "$gallery/three-spheres.png" "$gallery/07-diffuse.png" >"$scratch/said" 2>&1
}
check 'a picture whose chapter is blank is not an error' cast
check 'the missing answer is reported in one line' says "not yet   $gallery/07-diffuse.png: needs surface_normal (and 10 more)"
check 'the others are drawn' test -s "$gallery/three-spheres.png"
check 'a scene is exported without light' "build$answers/07-shading" --export pov -o "$scratch/scene.pov"
answer 07-shading '/^Color gamma_encode/,/^}/c Color gamma_encode(Color color, double gamma)\n{\n    return NOT_ANSWERED(Color);\n}'
check 'without gamma_encode a picture is drawn' cast
for_a_display() {
    "build$answers/07-shading" --gamma 2.2 -o "$scratch/gamma.png" >"$scratch/said" 2>&1
    [ $? -eq 1 ] && [ ! -e "$scratch/gamma.png" ] && says 'not answered yet: gamma_encode'
}
check 'for a display it is not, and the reason is reported' for_a_display

fresh
for solution in solutions/*.c; do
    cp "$solution" "$answers"
done
are_right() {
    make --no-print-directory status ANSWERS="$answers" >"$scratch/said" 2>&1
    count=$(grep -c '^EXERCISE(' tests/exercises.def)
    says "all chapters		$count of $count functions are right"
}
check 'the solutions are judged right' are_right
in_the_order_of_the_contract() {
    for contract in exercises/*.h; do
        stem=$(basename "$contract" .h)
        sed -n 's/^[A-Za-z].*[ *]\([a-z_0-9]*\)(.*/\1/p' "$contract" >"$scratch/contract"
        sed -n 's/^function\t//p' "build$answers/verdict/$stem.record" |
            diff "$scratch/contract" - || return
    done
}
check 'in the order of the contract' in_the_order_of_the_contract
answer 05-quadratic '/^Roots quadratic_roots/,/^}/c Roots quadratic_roots(Quadratic q)\n{\n    if (q.a == 0)\n        return q.b == 0 ? (Roots){0} : (Roots){1, {-q.c / q.b}};\n    double d = q.b * q.b - 4 * q.a * q.c;\n    return d < 0 ? (Roots){0} : ascending((-q.b - sqrt(d)) / (2 * q.a), (-q.b + sqrt(d)) / (2 * q.a));\n}
    /^Roots sphere_roots/,/^}/c Roots sphere_roots(Ray ray, Sphere sphere)\n{\n    return quadratic_roots(object_quadratic(to_object_coordinates(ray, sphere), sphere.radius));\n}'
judge EX=05
check 'the formula of the slide is right' says '05-quadratic     done'
check 'what it could do better is listed' says 'more digits in quadratic_roots,'
cp solutions/05-quadratic.c "$answers"
answer 06-ray-casting 's|nothing ? scene->background : ||'
judge EX=06
check 'the colour of sphere -1 is reported as missing' says 'scene_surface: sphere -1 does not exist'
cp solutions/06-ray-casting.c "$answers"
# In a picture that is higher than wide, that index is beyond the last depth.
answer 06-ray-casting 's|depth\[i\]|depth[i / width * height + i % width]|'
judge EX=06
check 'rows of the height are named, also where they leave the depth' says 'looks like depth[row * height + column]'

rm -rf "${BUILD:?}$answers"
finish exercises
