#!/bin/sh
# explain_slips.sh - what a student reads where an answer does not compile, by any compiler ($CC):
# slips of the fingers, other languages, braces, and how wide it is.
# Only reads the tree.
set -u
. tests/house/runner/explained.sh

# ---- slips of the fingers, and other languages --------------------------------------------------

explains 'retrun f(x)' 01-corners 's|return image_plane|retrun image_plane|' \
    'retrun is misspelled: return.'
explains 'retrun x' 01-corners 's|return c;|retrun c;|' 'retrun is misspelled: return.'
explains 'retunr (struct)' 03-screen 's|return (Norm|retunr (Norm|' 'retunr is misspelled: return.'
explains 'esle' 05-quadratic \
    's|    return NO_HIT;|    if (ray.origin[0] > 0) return 1;\n    esle return NO_HIT;|' \
    'esle is misspelled: else.'
explains 'wihle' 05-quadratic 's|    return NO_HIT;|    wihle (1) return 1;\n    return NO_HIT;|' \
    'wihle is misspelled: while.'
explains 'fi' 05-quadratic 's|        if (roots.t|        fi (roots.t|' 'fi is misspelled: if.'
explains 'flaot' 05-quadratic 's|double a = vec3_dot|flaot a = vec3_dot|' \
    'flaot is misspelled: float.'
explains 'doube' 05-quadratic 's|double a = vec3_dot|const doube a = vec3_dot|' \
    'doube is misspelled: double.'
broken 05-quadratic 's|for (int i|fro (int i|'
check 'fro' helps 'fro is misspelled: for.'
check 'fro, twice' [ "$(grep -c "^$answer:" "$scratch/said")" -eq 2 ]
broken 05-quadratic 's|return NO_HIT|return white|'
check 'what only looks like a keyword is none' says_not misspelled
broken 05-quadratic 's|return NO_HIT|return reurn * 2|'
check 'a word in a place where no keyword may be is not one' says_not misspelled

dash=$(printf '\342\200\223')
quotes=$(printf '\342\200\234x\342\200\235')
cross=$(printf '\303\227')
pasted='a character that is not C was pasted there: a dash, a quote, a sign or a space that only looks like one. Delete it and type it again.'
explains 'a pasted dash' 01-corners \
    "s|c.forward - c.width|c.forward $dash c.width|; /^vec3 upper_right/,\$s|$dash|-|" "$pasted"
explains 'pasted quotes' 05-quadratic \
    "s|    return NO_HIT;|    puts($quotes);\n    return NO_HIT;|; s|#include .common/ans.*|#include <stdio.h>|" \
    "$pasted"
explains 'a pasted cross' 02-cameras "s|return 2 . distance|return 2 $cross distance|" "$pasted"

explains 'std::' 02-cameras 's|return 2 .|return std::sqrt(2) *|' 'C has no std::'
explains 'vec3(...)' 01-corners 's|return image_plane_vector.*|return vec3(0, 0, 0);|' \
    'vec3 is a type, not a function: write vec3_of(x, y, z).'
explains '(vec3)(...)' 01-corners 's|return image_plane_vector.*|return (vec3)(0, 0, 0);|' \
    'a vec3 is written vec3_of(x, y, z).'
explains 'Ray(...)' 04-pixel-ray 's|return (Ray).*|return Ray(camera.origin, camera.up);|' \
    'Ray is a type, not a function: (Ray){origin, direction} makes one.'
explains '(Ray)(...)' 04-pixel-ray 's|return (Ray).*|return (Ray)(camera.origin, camera.up);|' \
    'a Ray is written (Ray){origin, direction}.'
explains 'new Ray(...)' 04-pixel-ray 's|return (Ray).*|return new Ray(camera.origin, camera.up);|' \
    'C has no new:'
explains 'types in a call' 05-quadratic 's|return NO_HIT|return vec3_dot(vec3 p, v)|' \
    'in a call, write only the values, without their types.'
explains 'return {...}' 03-screen 's|return (Normalized){|return {|' \
    'put the type in parentheses before the braces: (Normalized){s, t}.'
explains 'return {...} of a vector' 01-corners 's|return image_plane_vector.*|return {0, 0, 0};|' \
    'a vec3 is written vec3_of(x, y, z).'
lost='the value of (a, b) is b alone: the part before the comma is lost.'
explains 'return (a, b)' 03-screen 's|return (Normalized).*|return (point.x, point.y);|' \
    "$lost A Normalized is written (Normalized){s, t}."
explains 'return a, b' 03-screen 's|return (Normalized).*|return point.x, point.y;|' \
    "$lost A Normalized is written (Normalized){s, t}."
check 'a quote that went with another message is there' says 'return point.x, point.y;'
explains 'return (a, b, c) of a vector' 01-corners \
    's|return image_plane_vector.*|return (0, 0, 0);|' "$lost A vec3 is written vec3_of(x, y, z)."

explains '^ of numbers' 05-quadratic 's|radius \* radius}|radius^2}|' \
    '^ is exclusive or in C: write radius * radius.'
explains '^ of parts' 03-screen 's|point.x / screen.width|point.x^2|' \
    '^ is exclusive or in C: write point.x * point.x.'
explains '^ of vectors' 05-quadratic 's|vec3_dot(p, p) - radius|p^2 - radius|' \
    '^ is exclusive or in C: for v . v, write vec3_dot(p, p).'
explains '**' 05-quadratic 's|radius \* radius}|radius**2}|' 'C has no **: write radius * radius.'
explains '2c.distance' 01-corners \
    's|return c.distance \* c.forward -|return 2c.distance * c.forward -|' \
    'a * is missing: 2 * c.distance.'
explains '2distance' 02-cameras 's|return 2 . distance|return 2distance|' \
    'a * is missing: 2 * distance.'
explains '2(distance)' 02-cameras 's|return 2 . distance|return 2(distance)|' \
    'a * is missing before the bracket'

explains '^ to another power' 07-shading 's|pow(cosine, shine)|cosine^shine|' \
    '^ is exclusive or in C: write pow(cosine, shine).'
explains '** to another power' 07-shading 's|pow(cosine, shine)|cosine ** shine|' 'C has no **: write pow(cosine, shine).'
explains 'x between numbers' 01-corners 's|return image_plane_v.*|return c.distance x c.forward;|' \
    'x is not an operator in C: * multiplies, and the cross product is vec3_cross(v, w).'
explains 'a dot between numbers' 01-corners 's|return image_plane_v.*|return c.distance . c.forward;|' \
    'a dot is not a product in C: multiply numbers with *, and write v . w as vec3_dot(v, w).'
explains '=> for >=' 05-quadratic 's|(roots.t.i. > 0)|(roots.t[i] => 0)|' 'C writes >= and <=, not => and =<.'
explains 'if without a bracket' 05-quadratic 's|if (roots.t.i. > 0)|if roots.t[i] > 0|' \
    'if, while and for need parentheses: if (x > 0).'
explains 'a ) too few' 01-corners 's|return image_plane_v.*|return (c.distance * c.forward + c.up;|' \
    'a ) is missing: there are more ( than ).'
explains 'an operator left out in a struct' 05-quadratic 's|2 . vec3_dot(p, v), vec3_dot(p, p) - radius|2 vec3_dot(p, v), vec3_dot(p, p) - radius|' \
    'an operator or a comma is missing there (2 t is 2 * t).'

explains 'and' 05-quadratic 's|if (roots.t.i. > 0)|if (roots.t[i] > 0 and i < 2)|' \
    'and, or and not are written &&, || and ! in C.'
half=$(printf '\302\275')
dot=$(printf '\302\267')
explains 'a pasted half' 01-corners "s|return image_plane_v.*|return $half * c.width * c.right;|" "$pasted"
explains 'a pasted dot' 01-corners "s|return image_plane_v.*|return c.width $dot c.right;|" "$pasted"
explains 'a blank left out' 01-corners 's|return image_plane_v.*|returnc.distance * c.up;|' 'a space is missing: return c'
explains 'a ; in front of {' 01-corners '/^vec3 upper_left/s|$|;|' \
    "the ; at the end of line $(grep -n '^vec3 upper_left' solutions/01-corners.c | cut -d : -f 1) separates the function from its { }: remove it."
explains 'no type of result' 01-corners 's|^vec3 upper_left|upper_left|' \
    'the contract, exercises/01-corners.h, says vec3 upper_left(Camera c): your function must begin like that.'
explains 'a name that is taken' 01-corners 's|    c.distance = 1;|    int c = 1;|' \
    'c is already a parameter of with_unit_distance: give yours another name.'
explains 'a comma at the end of a line' 01-corners 's|    c.distance = 1;|    c.distance = 1,|' \
    "line $(grep -n '    c.distance = 1;' solutions/01-corners.c | cut -d : -f 1) ends with a comma, but needs a semicolon."
warned() {
    broken "$2" "$3"
    check "$1" helps "$4"
}
warned 'a header that is not there' 01-corners 's|"exercises/01-corners.h|"exercises/01-corner.h|' \
    'the contract of this chapter is #include "exercises/01-corners.h"; other headers are in common/.'
warned '== for =' 01-corners 's|    c.distance = 1;|    c.distance == 1;|' '== compares; to give a variable a value, write =.'
warned '= for ==' 05-quadratic 's|if (q.a == 0)|if (q.a = 0)|' '= assigns; to compare, write ==.'
warned '& for &&' 05-quadratic 's|if (roots.t.i. > 0)|if (i \& 1 > 0)|' '&& is and, || is or; & and | work on bits.'
warned 'a declaration after if' 05-quadratic '/^double hit_sphere/,/^}/s|return roots.t.i.;|float t = roots.t[i]; return t;|' \
    'a declaration after if, else or for needs braces around it: { }.'

# A decimal comma, wherever the compiler stumbles over it.
point='0,5 is two numbers in C. If you mean one number, write 0.5.'
decimal_comma() {
    broken "$2" "$3"
    check "a decimal comma $1" helps "$point"
    check "a decimal comma $1: said once" [ "$(grep -cE '(error|warning):' "$scratch/said")" -eq 1 ]
    check "a decimal comma $1: nothing else is advised" [ "$(grep -c 'help:' "$scratch/said")" -eq 1 ]
}
decimal_comma 'in brackets' 01-corners 's|(s - 0.5)|(s - 0,5)|'
decimal_comma 'in a sum' 01-corners 's|return image_plane_v.*|return c.distance * c.forward + 0,5 * c.width * c.right;|'
decimal_comma 'in a call' 01-corners 's|(c, 0.3, 0.1)|(c, 0,5, 0,1)|'
decimal_comma 'in a struct' 03-screen 's|pixel.column + 0.5|pixel.column + 0,5|'
decimal_comma 'in a declaration' 02-cameras 's|double distance = vec3_length(ahead)|double distance = 0,5|'
decimal_comma 'given to pow' 07-shading 's|pow(color.0., 1 / gamma)|pow(color[0], 0,5 / gamma)|'
broken 05-quadratic 's|vec3_dot(p, p) - radius|vec3_dot(p, p, vec3_of(0,5,1)) - radius|'
check 'three arguments without spaces are not a decimal comma' says_not 'two numbers'

# ---- semicolons and braces that say something else ----------------------------------------------

broken 05-quadratic 's|for (int i = 0; i < roots.count; i++)|&;|'
check 'a for that ends at once' \
    helps "the ; after for (...) in line $(line_of '; i++);') ends the loop: the next statement is no longer part of it."
check 'a for that ends at once: said once for each' [ "$(grep -c "^$answer:" "$scratch/said")" -eq 2 ]
explains 'a variable of a loop, used after it' 05-quadratic 's|return NO_HIT|return roots.t[i]|' \
    'i is known only inside the loop of line'

# Without the } of that function.
unclosed() {
    awk -v name="$2" 'index($0, " " name "(") { in_it = 1 } in_it && /^}/ { in_it = 0; next } { print }' \
        "solutions/$1.c" >"$scratch/$1.c"
    compile "$1"
    check "the } of $2 is missing" \
        helps "a } is missing, in or before the function that begins in line $(line_of " $2(")."
    check "the } of $2 is missing: alone" alone
}
unclosed 01-corners upper_left
unclosed 05-quadratic object_quadratic
unclosed 03-screen pixel_center
explains 'a { too many' 05-quadratic 's|(roots.t.i. > 0)|& {|' \
    'a } is missing, in or before the function that begins in line'
explains 'a } too many' 05-quadratic 's|Roots roots = sphere_roots(ray, sphere);|& }|' \
    'this is outside of every function: there is one } too many before it.'

# ---- the width ----------------------------------------------------------------------------------

broken 01-corners 's|return c.distance \* c.forward - c.width|return c.distance * c.forward + 0 * vec3_length(c.up) * vec3_length(c.right) * c.right * nothing - c.width|'
check 'long lines fit' only_their_own
caret_is_in_step() {
    cat "$scratch/said"
    awk '/nothing.*c\./ { at = index($0, "nothing") }
         /^[ |]*\^/ { in_step = at > 0 && index($0, "^") == at; exit }
         END { exit !in_step }' "$scratch/said"
}
check 'where a line is cut, the caret stays below its word' caret_is_in_step
wraps_at_words() {
    cat "$scratch/said"
    [ "$(sed -n 2p "$scratch/said" | cut -c 1-2)" = '  ' ] && ! sed -n 2p "$scratch/said" | grep '^   '
}
broken 05-quadratic 's|for (int i = 0; i < roots.count; i++)|for (int i = 0, i < roots.count, i++)|'
sed "s|$answer|$scratch/a-long-path-to-where-a-student-works/exercises/05-quadratic.c|" "$scratch/words" |
    "$explain" "$scratch/a-long-path-to-where-a-student-works/exercises/05-quadratic.c" >"$scratch/said"
check 'long messages are wrapped, indented by two' wraps_at_words

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
    echo '    double x = first + 1;'
    for name in second third fourth fifth; do
        echo "    x += $name;"
    done
    echo '    return x;'
    echo '}'
} >"$scratch/01-corners.c"
compile 01-corners
check 'three errors are shown' [ "$(grep -c "^$answer:" "$scratch/said")" -eq 3 ]
check 'and the rest counted' says '... and 2 more'

sed "s/'\\([^']*\\)'/‘\\1’/g" "$scratch/words" | "$explain" "$answer" >"$scratch/quotes"
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

: | "$explain" "$answer" >"$scratch/said"
check 'an empty message stays empty' [ ! -s "$scratch/said" ]

finish explain_slips
