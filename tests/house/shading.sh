#!/bin/sh
# shading.sh - what chapter 07's program draws and writes, and how it refuses.
# Only reads the tree.
set -u
. tests/house/runner/library.sh

program=${PROGRAMS:-build/solutions}/07-shading
scenes=chapters/06-ray-casting
same=$BUILD/tests/same_picture
three=$scenes/three-spheres.nff
size=96x72

draw_flat() {
    "$program" --flat -s $size -o "$scratch/flat.png" "$three" &&
        "${PROGRAMS:-build/solutions}/06-ray-casting" -s $size -o "$scratch/cast.png" "$three"
}
check 'a flat picture is drawn' draw_flat
check 'and it is that of chapter 06' "$same" "$scratch/flat.png" "$scratch/cast.png"

draw_terms() {
    for term in ambient diffuse specular; do
        "$program" -s $size --depth 0 --term $term -o "$scratch/$term.png" "$three" || return 1
    done
    "$program" -s $size --depth 0 -o "$scratch/whole.png" "$three"
}
terms_add_up() {
    python3 - "$scratch" <<'PY'
import sys
sys.path.insert(0, "tests/house/figures")
import png
parts = [png.pixels(f"{sys.argv[1]}/{name}.png") for name in ("ambient", "diffuse", "specular", "whole")]
# The background is the same in all four.
worst = max(abs(min(255, a + d + s) - w) for a, d, s, w in zip(*parts) if not a == d == s == w)
print("bytes differ by", worst)
sys.exit(worst > 2)
PY
}
check 'each term has a picture' draw_terms
if command -v python3 >/dev/null; then
    check 'and together they are the shaded one, but for rounding' terms_add_up
else
    echo "skipped: the sum of the terms: Python is missing ('make setup' installs it)"
fi

# 4 x 4 samples of a pixel are 16 pixels of a finer picture.
samples_are_the_mean() {
    "$program" -s 24x18 --samples 4 -o "$scratch/mean.png" "$three" &&
        "$program" -s 96x72 -o "$scratch/fine.png" "$three" && python3 - "$scratch" <<'PY'
import sys
sys.path.insert(0, "tests/house/figures")
import png
mean, fine = (png.pixels(f"{sys.argv[1]}/{name}.png") for name in ("mean", "fine"))
worst = 0
for i in range(24 * 18 * 3):
    column, row, c = i // 3 % 24, i // 72, i % 3
    those = [fine[3 * ((4 * row + y) * 96 + 4 * column + x) + c] for y in range(4) for x in range(4)]
    worst = max(worst, abs(sum(those) / 16 - mean[i]))
print("bytes differ by", worst)
sys.exit(worst > 1)
PY
}
if command -v python3 >/dev/null; then
    check 'a sampled pixel is the mean of its samples' samples_are_the_mean
else
    echo "skipped: the mean of samples: Python is missing ('make setup' installs it)"
fi
gamma_bends() {
    "$program" -s $size --gamma 2.2 -o "$scratch/gamma.png" "$three" &&
        ! "$same" "$scratch/gamma.png" "$scratch/whole.png"
}
check 'gamma changes the numbers' gamma_bends
sun_is_another() {
    "$program" -s $size --sun 0,1,0 -o "$scratch/sun.png" "$three" &&
        ! "$same" "$scratch/sun.png" "$scratch/whole.png"
}
check 'so does a distant light' sun_is_another

refuses() {
    words=$1
    wanted=$2
    shift 2
    "$program" "$@" >"$scratch/out" 2>"$scratch/err" </dev/null
    [ $? -eq "$wanted" ] && grep -q -e "$words" "$scratch/err" && [ ! -s "$scratch/out" ]
}
check 'no samples are refused' refuses 'samples' 2 --samples 0 "$three"
check 'nor is a gamma of 0 taken' refuses 'gamma' 2 --gamma 0 "$three"
check 'nor a depth that is not a number' refuses 'depth' 2 --depth many "$three"
check 'nor another term' refuses 'term' 2 --term glossy "$three"
check 'nor another renderer' refuses 'export' 2 --export blender -o x "$three"
check 'an export wants a file' refuses '-o FILE' 2 --export pov "$three"
check 'nor is less than no light' refuses 'ambient' 2 --ambient -3 "$three"
check 'nor a sun without a direction' refuses 'sun' 2 --sun 0,0,0 "$three"
check 'the existing terms are listed' refuses 'ambient, diffuse' 2 --term glossy "$three"
check 'two scenes are one too many' refuses '2 scenes' 2 "$three" "$three"
check 'a missing scene is reported' refuses 'cannot be read' 1 -o "$scratch/x.png" none.nff
check 'a full disk is reported, and nothing is left' refuses 'written' 1 --export pov -o /dev/full "$three"

exports() {
    "$program" "$@" "$three" && [ -s "$scratch/scene.pov" ]
}
check 'a scene is written for POV-Ray' exports --export pov -o "$scratch/scene.pov"
numbers_come_back() {
    "$program" --export pbrt -o "$scratch/scene.pbrt" "$three" &&
        python3 tests/house/figures/pbrt.py "$scratch/scene.pbrt" "$three"
}
if command -v python3 >/dev/null; then
    check 'a scene for pbrt has its syntax, and the same camera and spheres' numbers_come_back
else
    echo "skipped: the reader of pbrt files: Python is missing ('make setup' installs it)"
fi

# The lesson's last picture takes too long to be drawn here: some pixels of it.
pixels_of_the_lesson() {
    for pixel in 240,180 130,140 330,250 200,300 10,10; do
        "$program" -s 480x360 --depth 3 --explain $pixel "$BUILD/scenes/sphereflake-7381.nff" >"$scratch/told" || return 1
        PIXEL=$pixel python3 - "$scratch/told" <<'PY' || return 1
import os
import re
import sys
sys.path.insert(0, "tests/house/figures")
import png
column, row = map(int, os.environ["PIXEL"].split(","))
at = 3 * (row * 480 + column)
drawn = png.pixels("chapters/07-shading/sphereflake.png")[at:at + 3]
with open(sys.argv[1]) as told:
    color = re.findall(r"(?:clamped|background,) +\((.*)\)", told.read())[-1]
wanted = [255 * float(part) for part in color.split(",")]
print(column, row, list(drawn), wanted)
sys.exit(max(abs(a - b) for a, b in zip(drawn, wanted)) > 1)
PY
    done
}
if command -v python3 >/dev/null; then
    check "the lesson's last picture is what the program draws" pixels_of_the_lesson
else
    echo "skipped: pixels of the last picture: Python is missing ('make setup' installs it)"
fi
finish shading
