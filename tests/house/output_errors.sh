#!/bin/sh
# output_errors.sh - a program whose output cannot be printed says so and ends with 1; numbers that are none.
# Only reads the tree.
set -u
. tests/house/runner/library.sh

scene=chapters/06-ray-casting/three-spheres.nff
# The folder for pictures of programs without -o.
mkdir "$scratch/programs"
for program in "$PROGRAMS"/0[1-8]-*; do
    { [ -f "$program" ] && [ -x "$program" ]; } || continue
    cp "$program" "$scratch/programs"
done
ln -s "$here/chapters" "$scratch/chapters"

says_that_it_cannot_print() {
    "$@" >/dev/full 2>"$scratch/said"
    status=$?
    cat "$scratch/said"
    [ $status -eq 1 ] && [ "$(grep -c ': cannot print: ' "$scratch/said")" -eq 1 ]
}
nothing_to_print() {
    "$@" >/dev/full 2>"$scratch/said"
}
if [ -c /dev/full ]; then
    for program in "$scratch"/programs/*; do
        name=${program##*/}
        check "$name: a story that cannot be printed is an error" says_that_it_cannot_print "$program"
        check "$name: so is help" says_that_it_cannot_print "$program" --help
    done
    check 'so is a figure' says_that_it_cannot_print "$scratch/programs/05-quadratic" --figure parabola
    check 'so is a pixel explained' says_that_it_cannot_print "$scratch/programs/06-ray-casting" --explain 9,9
    check 'and the light at one' says_that_it_cannot_print "$scratch/programs/07-shading" --explain 9,9
    check 'and the name of a picture' says_that_it_cannot_print "$scratch/programs/06-ray-casting" -s 8x6 "$scene"
    check 'what prints nothing needs no room' nothing_to_print "$scratch/programs/06-ray-casting" -s 8x6 \
        -o "$scratch/a.png" "$scene"
    check 'a scene that cannot be printed is an error' says_that_it_cannot_print \
        "$BUILD/chapters/06-ray-casting/sphereflake_nff" 2
    check 'a longer one as well' says_that_it_cannot_print "$BUILD/chapters/06-ray-casting/sphereflake_nff" 4
    check 'and the sunflower' says_that_it_cannot_print "$BUILD/chapters/06-ray-casting/sunflower_nff"
else
    echo 'skipped: output that cannot be printed: this system has no /dev/full'
fi

refuses() {
    "$@" >"$scratch/out" 2>"$scratch/said"
    status=$?
    cat "$scratch/said"
    [ $status -eq 2 ] && [ ! -s "$scratch/out" ] && grep -q '^Usage: ' "$scratch/said"
}
for size in 1e3 2.5 0 7 -1 +2 ' 2' 2x '' 99999999999999999999; do
    check "a sphereflake of '$size' is refused" refuses "$BUILD/chapters/06-ray-casting/sphereflake_nff" "$size"
done
check 'and one of nothing' refuses "$BUILD/chapters/06-ray-casting/sphereflake_nff"
check 'and of two numbers' refuses "$BUILD/chapters/06-ray-casting/sphereflake_nff" 2 2
check 'the sunflower takes no number' refuses "$BUILD/chapters/06-ray-casting/sunflower_nff" 2

# The output file must not be the input file.
is_kept() {
    "$scratch/programs/$1" -s 8x6 -o "$2" "$3" >"$scratch/said" 2>&1
    status=$?
    cat "$scratch/said"
    [ $status -eq 2 ] && grep -q 'is the scene itself' "$scratch/said" && cmp "$scene" "$scratch/a.nff"
}
cp "$scene" "$scratch/a.nff"
ln "$scratch/a.nff" "$scratch/hard.png"
ln -s a.nff "$scratch/soft.png"
for name in 06-ray-casting 07-shading 08-fast; do
    check "$name: the scene is not written over" is_kept $name "$scratch/a.nff" "$scratch/a.nff"
    check "$name: nor by another path" is_kept $name "$scratch/programs/../a.nff" "$scratch/a.nff"
    check "$name: nor by a link to it" is_kept $name "$scratch/soft.png" "$scratch/a.nff"
    check "$name: nor by a second name of it" is_kept $name "$scratch/hard.png" "$scratch/a.nff"
done
exports_over_it() {
    "$scratch/programs/07-shading" --export pov -o "$scratch/a.nff" "$scratch/a.nff" 2>"$scratch/said"
    [ $? -eq 2 ] && cmp "$scene" "$scratch/a.nff"
}
check 'nor by an export' exports_over_it
finish output_errors
