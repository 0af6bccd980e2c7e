#!/bin/sh
# shading.sh - what chapter 07's program draws and writes, and that chapter 08's draws the same. What they refuse is in
# command_line.txt.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
needs shading "shaded pictures" python3

program=$PROGRAMS/07-shading
three=chapters/06-ray-casting/three-spheres.nff
export PYTHONPATH=tests/house/figures
draw() { # NAME ARGUMENTS...
    name=$1
    shift
    "$program" "$@" -o "$scratch/$name.png" "$three"
}
other() { # NAME ARGUMENTS...: another picture than the whole one
    draw "$@" -s 96x72 && ! same_picture "$scratch/$1.png" "$scratch/whole.png"
}

check 'a flat picture is drawn' draw flat --flat -s 96x72
check 'and chapter 06 draws it' "$PROGRAMS/06-ray-casting" -s 96x72 -o "$scratch/cast.png" "$three"
check 'the same' same_picture "$scratch/flat.png" "$scratch/cast.png"

for term in ambient diffuse specular; do
    check "$term light has a picture" draw $term -s 96x72 --depth 0 --term $term
done
check 'so has all of it' draw whole -s 96x72 --depth 0
# The background is the same in all four.
check 'and its terms add up to it, but for rounding' python3 -c '
import sys, png
parts = [png.pixels(f"{sys.argv[1]}/{name}.png") for name in ("ambient", "diffuse", "specular", "whole")]
worst = max(abs(min(255, a + d + s) - w) for a, d, s, w in zip(*parts) if not a == d == s == w)
sys.exit(worst > 2 and f"bytes differ by {worst}")' "$scratch"
# 4 x 4 samples of a pixel are 16 pixels of a finer picture.
check 'a pixel is sampled' draw mean -s 24x18 --samples 4
check 'a finer picture is drawn' draw fine -s 96x72
check 'of which the sampled one is the mean' python3 -c '
import sys, png
mean, fine = (png.pixels(f"{sys.argv[1]}/{name}.png") for name in ("mean", "fine"))
worst = 0
for i in range(24 * 18 * 3):
    column, row, c = i // 3 % 24, i // 72, i % 3
    those = [fine[3 * ((4 * row + y) * 96 + 4 * column + x) + c] for y in range(4) for x in range(4)]
    worst = max(worst, abs(sum(those) / 16 - mean[i]))
sys.exit(worst > 1 and f"bytes differ by {worst}")' "$scratch"
check 'gamma changes the numbers' other gamma --gamma 2.2
check 'so does a distant light' other sun --sun 0,1,0

check 'a scene is written for POV-Ray' "$program" --export pov -o "$scratch/scene.pov" "$three"
check 'and is there' test -s "$scratch/scene.pov"

# The lesson's last picture takes too long to be drawn here: some pixels of it.
for pixel in 240,180 130,140 330,250 200,300 10,10; do
    "$program" -s 480x360 --depth 3 --explain $pixel "$BUILD/scenes/sphereflake-7381.nff" >"$scratch/told"
    check "pixel $pixel of the lesson's last picture is what the program draws" python3 -c '
import re, sys, png
column, row = map(int, sys.argv[1].split(","))
at = 3 * (row * 480 + column)
drawn = png.pixels("chapters/07-shading/sphereflake.png")[at:at + 3]
color = re.findall(r"(?:clamped|background,) +\((.*)\)", open(sys.argv[2]).read())[-1]
wanted = [255 * float(part) for part in color.split(",")]
sys.exit(max(abs(a - b) for a, b in zip(drawn, wanted)) > 1 and f"{list(drawn)}, expected {wanted}")' $pixel "$scratch/told"
done

# ---- chapter 08 -----------------------------------------------------------------------------------

# The same bytes, by the hierarchy and by chapter 07's own loop, with that many threads.
draws_the_same() {
    threads=$1
    shift
    "$PROGRAMS/07-shading" "$@" -o "$scratch/right.png" || return 1
    for engine in auto bvh plain; do
        "$PROGRAMS/08-fast" --shaded --engine $engine --threads "$threads" "$@" -o "$scratch/fast.png" &&
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
    "$PROGRAMS/08-fast" --threads 2 -s 64x48 -o "$scratch/right.png" "$flake" &&
        cat "$flake" | "$PROGRAMS/08-fast" --threads 2 -s 64x48 -o "$scratch/fast.png" /dev/stdin &&
        cmp "$scratch/right.png" "$scratch/fast.png"
}
check 'a scene may come through a pipe' reads_a_pipe

# Extreme numbers are in the scenes of tests/house/engines.
printf '%s\n' v 'from 0 0 1e16' 'at 0 0 0' 'up 0 1 0' 'angle 1e-14' 'resolution 20 15' 's 0 0 0 1' >"$scratch/extreme.nff"
says_who_casts() {
    "$PROGRAMS/08-fast" --engine bins -o "$scratch/fast.png" "$scratch/extreme.nff" 2>"$scratch/said" &&
        says 'bins: the scene has extreme numbers (see --help), so plain casts it'
}
check 'of extreme numbers, who casts them is named' says_who_casts

# The commands of the lesson and of the page on engines draw their pictures, in another folder. make is left out: it would build in this
# tree, with the user's answers; tests/proof/shading.sh tests that picture.
lesson_is_right() {
    awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside && !/^make /' \
        chapters/08-fast/README.md chapters/08-fast/engines.md |
        sed "s|^build/solutions/|$PROGRAMS/|; s| -o build/| -o $scratch/|; s| build/| $BUILD/|" >"$scratch/commands"
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
    "$PROGRAMS/08-fast" --rectangles >"$scratch/rectangles" || return 1
    [ "$(grep -c questions "$scratch/rectangles")" -eq 2 ] &&
        sed '1,/^On a screen/d; /^$/d' "$scratch/rectangles" | while IFS= read -r line; do
            grep -qxF -e "$line" chapters/08-fast/README.md || { echo "not there: $line" && return 1; }
        done
}
check "the lesson's rectangles are those that the program prints" quotes_the_rectangles

finish shading
