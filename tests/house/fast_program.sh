#!/bin/sh
# fast_program.sh - chapter 08's program draws chapter 07's pictures, and refuses what it cannot.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh

programs=${PROGRAMS:-build/solutions}
three=chapters/06-ray-casting/three-spheres.nff

# The same bytes, by the hierarchy and by chapter 07's own loop, with that many threads.
draws_the_same() {
    threads=$1
    shift
    "$programs/07-shading" "$@" -o "$scratch/right.png" || return 1
    for engine in auto bvh plain; do
        "$programs/08-fast" --shaded --engine $engine --threads "$threads" "$@" -o "$scratch/fast.png" &&
            cmp "$scratch/right.png" "$scratch/fast.png" || return 1
    done
}
flake=$BUILD/scenes/sphereflake-820.nff
check 'shadows and mirrors are the same' draws_the_same 1 -s 64x48 "$flake"
check 'and with three threads' draws_the_same 3 -s 63x47 --depth 1 "$flake"
check 'and sampled, for a display' draws_the_same 2 -s 24x18 --samples 2 --gamma 2.2 "$flake"
check 'and in the sun' draws_the_same 1 -s 32x24 --sun 1,1,1 --ambient 0.3 --depth 0 "$flake"
check 'and of a scene without mirrors' draws_the_same 1 -s 64x48 "$BUILD/scenes/sunflower.nff"
check 'and of three spheres' draws_the_same 2 -s 96x72 "$three"

# A pipe has no size, and cannot be read in parts.
reads_a_pipe() {
    flake=$BUILD/scenes/sphereflake-7381.nff
    # shellcheck disable=SC2002 # a file would not be a pipe
    "$programs/08-fast" --threads 2 -s 64x48 -o "$scratch/right.png" "$flake" &&
        cat "$flake" | "$programs/08-fast" --threads 2 -s 64x48 -o "$scratch/fast.png" /dev/stdin &&
        cmp "$scratch/right.png" "$scratch/fast.png"
}
check 'a scene may come through a pipe' reads_a_pipe

# Extreme numbers are in the scenes of tests/house/engines.
printf '%s\n' v 'from 0 0 1e16' 'at 0 0 0' 'up 0 1 0' 'angle 1e-14' 'resolution 20 15' 's 0 0 0 1' >"$scratch/extreme.nff"
says_who_casts() {
    "$programs/08-fast" --engine bins -o "$scratch/fast.png" "$scratch/extreme.nff" 2>"$scratch/said" &&
        says 'bins: the scene has extreme numbers (see --help), so plain casts it'
}
check 'of extreme numbers, who casts them is named' says_who_casts

# The commands of the lesson and of the page on engines draw their pictures, in another folder. make is left out: it would build in this
# tree, with the user's answers; tests/proof/finale.sh tests that picture.
lesson_is_right() {
    awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside && !/^make /' \
        chapters/08-fast/README.md chapters/08-fast/engines.md |
        sed "s|^build/solutions/|$programs/|; s| -o build/| -o $scratch/|; s| build/| $BUILD/|" >"$scratch/commands"
    [ -s "$scratch/commands" ] && sh -e "$scratch/commands"
}
check "the lesson's commands draw" lesson_is_right
# pow may round differently on another machine.
check "one of them the last picture of chapter 07's lesson" \
    same_picture "$scratch/last.png" chapters/07-shading/sphereflake.png 100

# A number that was measured is typed nowhere.
tables() {
    python3 -B tests/benches/tables.py "$@"
}
quotes_the_bench() {
    page=chapters/08-fast/engines.md
    tables chapters/08-fast/figures >"$scratch/table" && [ "$(wc -l <"$scratch/table")" -gt 5 ] &&
        tables chapters/08-fast/figures $page >"$scratch/page" && diff "$scratch/page" $page
}
check 'the table of the page on engines is what was measured' quotes_the_bench
needs_a_place() {
    grep -v '^| this program' chapters/08-fast/engines.md >"$scratch/page"
    ! tables chapters/08-fast/figures "$scratch/page" >"$scratch/out" 2>"$scratch/err" &&
        grep -q 'no table that begins with | this program, times as fast as |' "$scratch/err"
}
check 'a table that the page has no place for is not lost' needs_a_place
quotes_the_rectangles() {
    "$programs/08-fast" --rectangles >"$scratch/rectangles" || return 1
    [ "$(grep -c questions "$scratch/rectangles")" -eq 2 ] &&
        sed '1,/^On a screen/d; /^$/d' "$scratch/rectangles" | while IFS= read -r line; do
            grep -qxF -e "$line" chapters/08-fast/README.md || { echo "not there: $line" && return 1; }
        done
}
check "the lesson's rectangles are those that the program prints" quotes_the_rectangles

finish fast_program
