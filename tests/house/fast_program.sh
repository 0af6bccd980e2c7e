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

# Numbers at the end of what a double holds: no engine crashes, and the picture is chapter 06's (07's).
extreme() {
    printf '%s\n' v "from 0 0 $1" 'at 0 0 0' 'up 0 1 0' "angle $2" 'resolution 20 15' 'l 5 5 5' >"$scratch/extreme.nff"
    shift 2
    printf '%s\n' "$@" >>"$scratch/extreme.nff"
    "$programs/06-ray-casting" -o "$scratch/right.png" "$scratch/extreme.nff" || return 1
    for engine in plain object bvh packet tiles bins; do
        "$programs/08-fast" --engine $engine --threads 2 -o "$scratch/fast.png" "$scratch/extreme.nff" &&
            same_picture "$scratch/right.png" "$scratch/fast.png" || return 1
    done
    draws_the_same 2 "$scratch/extreme.nff"
}
check 'spheres at both ends of the world' extreme 9 40 's 1e308 0 0 1' 's -1e308 0 0 1' 's 0 0 0 1'
check 'spheres as large as can be' extreme 9 40 's 0 0 0 1e308' 's 1e308 1e308 1e308 1e308' 's 0 0 0 1'
check 'spheres as small as can be' extreme 9 40 's 0 0 0 1e-308' 's 0 0 8 1e-323' 's 0.1 0 0 1'
check 'an eye as far away as can be' extreme 1e150 1e-148 's 0 0 0 1' 's 1 0 0 2' 's 0 1 1 1'
check 'an eye 1e14 radii away' extreme 1e14 1e-12 's 0 0 0 1' 's 1 0 0 0.2' 's 0 1 1 0.3'
mirror='f 1 0.5 0.2 0.5 0.5 10 0 0'
set -- 's 1 0 0 0.2' 's 0 1 1 0.3' 's -1 0 1 0.3' 's 0 -1 1 0.3'
check 'an eye 1e8 radii away from mirrors' extreme 1e8 2e-6 "$mirror" 's 0 0 0 1' "$@"
check 'in a mirror of radius 1e7' extreme 5 60 "$mirror" 's 0 200 0 1e7' "$@"
check 'an eye 1e16 radii away' extreme 1e16 1e-14 's 0 0 0 1' 's 1 0 0 0.2' 's 0 1 1 0.3'
says_who_casts() {
    "$programs/08-fast" --engine bins -o "$scratch/fast.png" "$scratch/extreme.nff" 2>"$scratch/said" &&
        says 'bins: the scene has extreme numbers (see --help), so plain casts it'
}
check 'and the engine is named' says_who_casts

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
