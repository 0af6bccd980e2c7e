#!/bin/sh
# explain.sh - what a student reads where an answer does not compile, by any compiler ($CC).
set -u
. tests/library.sh

cc=${CC:-cc}
flags="-std=c11 -D_DEFAULT_SOURCE -ffp-contract=off -Wno-psabi -I. -Wall -Wextra -Wno-unused-parameter"

# The compiler's words are in $scratch/words, what is made of them in $scratch/said.
compile() {
    answer=$scratch/$1.c
    # shellcheck disable=SC2086 # the compiler and its flags are words
    LC_ALL=C $cc $flags -c -o "$scratch/answer.o" "$answer" 2>"$scratch/words"
    .make/explain "$answer" <"$scratch/words" >"$scratch/said" 2>&1
}
# The solution of a stem, but for a line: the sed command.
broken() {
    sed "$2" "solutions/$1.c" >"$scratch/$1.c"
    compile "$1"
}
line_of() {
    grep -n -m 1 -F -- "$1" "$answer" | cut -d : -f 1
}
# Help may be wrapped: it is looked for as one line.
says() {
    cat "$scratch/said"
    tr -s '\n ' '  ' <"$scratch/said" | grep -qF -- "$1"
}
says_not() {
    ! says "$1"
}
helps() {
    says " help: $1"
}
only_their_own() {
    cat "$scratch/said"
    grep -q "^$answer:[0-9]" "$scratch/said" &&
        ! grep -E '^[^ |]+:[0-9]+:' "$scratch/said" | grep -vF "$answer:" &&
        ! grep -E '^In file|^ +from |^cc1|: In function|generated\.$|terminated' "$scratch/said" &&
        ! grep -E '^.{101}| $' "$scratch/said"
}

# ---- the common five, and the missing return ----------------------------------------------------

broken 01-corners 's|c.height / 2 \* c.up;|c.height / 2 * c.up|'
check 'a missing semicolon is said, with its line' \
    helps "a semicolon is missing at the end of line $(line_of 'c.height / 2 * c.up')."
check 'a missing semicolon: only their own file' only_their_own
check 'help that was given is not repeated' [ "$(grep -c 'help:' "$scratch/said")" -eq 2 ]

broken 02-cameras 's|vec3 ahead = view.at - view.eye;|vec3 ahead = view.at - view.eye // no|'
check 'where the next line is blamed, the line before is named' \
    helps "a semicolon is missing at the end of line $(line_of 'vec3 ahead')."
check 'what only follows from a missing semicolon is left out' says_not 'undeclared'

broken 01-corners 's|return c.distance \* c.forward|return c.distance c.forward|'
check 'a missing operator is no missing semicolon alone' helps "in line $(line_of 'distance c.f') a semicolon is missing, or an operator"

broken 05-quadratic 's|double a = vec3_dot(v, v);|double a = v * v;|'
check 'v * v as a number: vec3_dot is named' helps 'v * w multiplies component by component and is a vector; for a number, say vec3_dot(v, w).'
check 'v * v as a number: only their own file' only_their_own
check 'nobody is told what a vec3 is made of' says_not '__vector'
broken 05-quadratic 's|double l = fmin.*|double l = sqrt(closest * closest);|'
check 'v * v handed to sqrt: vec3_dot is named' helps 'v * w multiplies'
check 'v * v handed to sqrt: only their own file' only_their_own
broken 05-quadratic 's|if (!(l_squared <= r \* r))|if (closest * closest > r * r)|'
check 'v * v compared with a number: vec3_dot is named' helps 'v * w multiplies'
broken 02-cameras 's|return 2 \* distance \* tan.*|vec3 v = {1, 2, 3}; return v * v;|'
check 'v * v returned as a number: vec3_dot is named' helps 'v * w multiplies'
broken 02-cameras 's|double distance = vec3_length(ahead)|double distance = ahead|'
check 'a vector for a number, without a product, is told how to become one' \
    helps 'a vector stands where a number is wanted'
broken 05-quadratic 's|vec3_dot(p, p) - radius|vec3_dot(p, radius) - radius|'
check 'a number for a vector gets no such help' says_not 'help:'

broken 05-quadratic 's|double a = vec3_dot(v, v);|double a = v.x * v.x;|'
check 'v.x is told to be v[0]' helps 'a vec3 has no parts with names: its components are v[0], v[1], v[2].'

broken 05-quadratic 's|return NO_HIT|return nothing|'
check 'an undeclared name is told where to look' \
    helps 'nothing here is called nothing. Is it spelled as in the contract, exercises/05-quadratic.h?'
broken 05-quadratic 's|roots = sphere_roots|roots = spere_roots|'
check 'an undeclared function is told where to look' helps 'nothing here is called spere_roots.'
check 'what only follows from an undeclared function is left out' \
    [ "$(grep -c "^$answer:" "$scratch/said")" -eq 1 ]
broken 01-corners 's|c.width / 2|width / 2|'
check 'a part without its whole is told whose it is' helps 'width is a part of a Camera (common/camera.h)'
broken 02-cameras 's|PI / 180|M_PI / 180|; s|^// Stores.*|#undef M_PI|'
check 'M_PI is told to be PI' helps 'C11 has no M_PI: say PI (common/vec3.h).'
broken 06-ray-casting '/#include "exercises.05/d'
check 'a function of another chapter is told its header' \
    helps 'hit_sphere is declared elsewhere: #include "exercises/05-quadratic.h"'
broken 01-corners 's|return c.distance \* c.forward -|printf("here");\n    &|'
check 'printf is told its header' helps 'printf is in the standard library: #include <stdio.h>'

broken 05-quadratic 's|vec3_dot(p, p) - radius|vec3_dot(p) - radius|'
check 'too few arguments: the prototype is shown' \
    helps 'its prototype is double vec3_dot(vec3 v, vec3 w) in common/vec3.h.'
check 'too few arguments: only their own file' only_their_own
broken 05-quadratic 's|vec3_dot(p, p) - radius|vec3_dot(p, p, v) - radius|'
check 'too many arguments: the prototype is shown' helps 'its prototype is double vec3_dot('
broken 06-ray-casting 's|pixel_ray(camera, image->size, pixel)|pixel_ray(camera, pixel)|'
check 'one left out in the middle is too few, not a wrong type' says_not 'incompatible'
check 'one left out in the middle: the prototype is shown' \
    helps 'its prototype is Ray pixel_ray(Camera camera, Resolution screen, Pixel pixel) in exercises/04-pixel-ray.h.'

broken 02-cameras 's|return 2 \* distance \* tan.*|if (distance > 3) return 2;|'
check 'a missing return is told what comes of it' helps 'the function ends without return'
broken 01-corners 's|c.width / 2 \* c.right + c.height / 2 \* c.up;|w;|'
check 'but not where the return is what is wrong' says_not 'ends without return'

# ---- the rest -----------------------------------------------------------------------------------

broken 03-screen 's|// BEGIN SOLUTION|int unused; &|; s|pixel.row|pixel.line|'
check 'an error and a warning are both said' [ "$(grep -cE 'error: .*line|warning: .*unused' "$scratch/said")" -ge 2 ]
first_line_is_an_error() {
    head -n 1 "$scratch/said" | grep 'error:'
}
check 'and the first line is an error' first_line_is_an_error

{
    echo '#include "exercises/01-corners.h"'
    echo 'double f(void)'
    echo '{'
    echo '    double x = a + 1;'
    for name in b c d e; do
        echo "    x += $name;"
    done
    echo '    return x;'
    echo '}'
} >"$scratch/01-corners.c"
compile 01-corners
check 'three errors are shown' [ "$(grep -c "^$answer:" "$scratch/said")" -eq 3 ]
check 'and the rest counted' says '... and 2 more'

sed "s/'\\([^']*\\)'/‘\\1’/g" "$scratch/words" | .make/explain "$answer" >"$scratch/quotes"
check 'typographic quotes change nothing' diff "$scratch/said" "$scratch/quotes"

{
    echo '#include "exercises/01-corners.h"'
    printf 'double f(void) { return nothing; /* \033[31m gr\303\274n \001 %0200d */ }\n' 0
} >"$scratch/01-corners.c"
compile 01-corners
check 'the line is quoted' says 'double f(void) { return nothing; /* '
check 'what cannot be printed is not, and lines end' only_their_own
check 'nothing but plain text' [ "$(tr -d '\n -~' <"$scratch/said" | wc -c)" -eq 0 ]

{
    echo 'static int early(int a)'
    echo '#include "exercises/03-screen.h"'
} >"$scratch/03-screen.c"
compile 03-screen
check 'a header that a student spoils still leads to their file' says "$answer:"

: | .make/explain "$answer" >"$scratch/said"
check 'of nothing, nothing is said' [ ! -s "$scratch/said" ]

finish explain
