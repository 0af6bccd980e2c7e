#!/bin/sh
# shading.sh - what chapter 07's program draws and writes. What it refuses is in command_line.txt.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
needs shading "chapter 07's pictures" python3

program=${PROGRAMS:-build/solutions}/07-shading
scenes=chapters/06-ray-casting
three=$scenes/three-spheres.nff
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
check 'and chapter 06 draws it' "${PROGRAMS:-build/solutions}/06-ray-casting" -s 96x72 -o "$scratch/cast.png" "$three"
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
finish shading
