#!/bin/sh
# figures.sh - figures of 500 cameras in each of four chapters, of 500 rays and scenes in two, from 1e-6 to 1e6 (fewer
# with MOST_CAMERAS and MOST_SCENES); all figures of 500 examples (MOST_EXAMPLES); those of all known mistakes (with
# MISTAKES=10 each tenth); and all files that make figures makes (with STEPS_OF=N, the steps of N figures).
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once 'figures, long' "hundreds of figures of each kind"

needs 'figures, long' 'figures' gnuplot python3

CAMERAS=${MOST_CAMERAS:-500} SCENES=${MOST_SCENES:-500} MISTAKES=${MISTAKES:-1} counted sh tests/house/figures.sh random

export PROGRAMS PYTHONPATH=tests/house/figures
# shellcheck disable=SC2016 # the inner shell expands them
seq 1000 $((999 + ${MOST_EXAMPLES:-500})) | xargs -P "$(getconf _NPROCESSORS_ONLN)" -n 1 \
    sh -c 'python3 -B tests/proof/random_example.py "$1" --clear >"$0-$1" 2>&1' "$scratch/examples"
for log in "$scratch"/examples-*; do
    counted cat "$log"
done

# Draws by the rules of the environment; prints its output.
drawn=$scratch/figures
draws() {
    folder=$1
    shift
    # shellcheck disable=SC2086 # names are words
    env "$@" python3 chapters/gallery/draw_figures.py "$folder" $names >"$scratch/said" 2>&1
    status=$?
    sed -i '/^  figures  .* left$/d' "$scratch/said" # how far it is
    return $status
}
without_a_word() {
    draws "$@"
    status=$?
    cat "$scratch/said"
    [ $status -eq 0 ] && [ "$(wc -l <"$scratch/said")" -eq 1 ]
}
fails() {
    ! "$@"
}
check 'every figure has a script' scripts_into "$drawn"

check 'all figures are drawn, in every format and theme, without a word' \
    without_a_word "$drawn" FORMAT=svg,pdf,png,tex
check 'an existing figure is not drawn again' without_a_word "$drawn" FORMAT=svg,pdf,png,tex
check 'and that is reported' says '(0 drawn now)'

# Four of them, in another time zone, and a second later at least.
all=$names
names=$(echo "$all" | cut -d' ' -f2-5)
for name in $names; do
    mkdir -p "$scratch/again" "$scratch/first"
    cp -r "$drawn/$name" "$scratch/again"
    cp -r "$drawn/$name" "$scratch/first"
done
find "$scratch/again" -mindepth 2 -maxdepth 2 -type f ! -path '*/.drawn/*' ! -name '*.gp' -exec rm '{}' +
same_bytes() {
    diff -r -x .drawn "$scratch/again" "$scratch/first"
}
check 'drawn once more' without_a_word "$scratch/again" FORMAT=svg,pdf,png,tex TZ=Asia/Tokyo
check 'every file has the same bytes' same_bytes

names=$(echo "$all" | cut -d' ' -f"2-$((${STEPS_OF:-999} + 1))")
check 'both shapes and every step are drawn without a word' \
    without_a_word "$drawn" FORMAT=svg,pdf,png,tex SHAPE=16:9,4:3 STEPS=1
# shellcheck disable=SC2086
counted python3 tests/house/figures/outputs.py "$drawn" $names
names=$all
nothing_is_left() {
    [ -z "$(find "$drawn" -name '.?*' ! -name .drawn)" ]
}
check 'no file of the work is left' nothing_is_left

# A mistake is reported, and no older figure is lost.
first=$(echo "$names" | cut -d' ' -f2)
one=$scratch/one
mkdir -p "$one/$first"
cp "$drawn/$first/$first.gp" "$one/$first/"
names=$first
check 'a format that there is none of is refused' fails draws "$one" FORMAT=svg,jpg
check 'with those that there are' says 'FORMAT=jpg: expected svg, pdf, png, tex'
check 'so is a theme' fails draws "$one" THEME=grey
check 'and a shape' fails draws "$one" SHAPE=1:1
check 'and no list at all' fails draws "$one" FORMAT=,
check 'one picture alone can be drawn' without_a_word "$one" FORMAT=png THEME=dark SHAPE=4:3
check 'and no other' test "$(echo "$one"/*/*.png)" = "$one/$first/$first-4x3-dark.png"
check 'a picture of a script' without_a_word "$one" FORMAT=svg
cp "$one/$first/$first.svg" "$scratch/before.svg"
sed '/^# ---- the layout$/{n
a\
print no_such_number
}' "$drawn/$first/$first.gp" >"$one/$first/$first.gp"
check 'a mistake in a layout is a failure' fails draws "$one" FORMAT=svg
check 'the message names the line of the layout' says "$(echo chapters/*/figures/"$first.gp"):1: gnuplot: undefined variable: no_such_number"
check 'once' test "$(wc -l <"$scratch/said")" -eq 1
check 'the older picture is left as it was' cmp "$one/$first/$first.svg" "$scratch/before.svg"
sed '$a\
number = 1 +' "$drawn/$first/$first.gp" >"$one/$first/$first.gp"
check 'so is a syntax error' fails draws "$one" FORMAT=svg
check 'with the text of that place' says 'near: number = 1 +'
cp "$drawn/$first/$first.gp" "$one/$first/"
echo 'set print "-"; print "a word of warning"' >>"$one/$first/$first.gp"
check 'what gnuplot says besides is passed on' draws "$one" FORMAT=svg
check 'with the picture' says 'a word of warning'

# Without gnuplot; without a font.
cp "$drawn/$first/$first.gp" "$one/$first/"
check 'without gnuplot it fails' fails without gnuplot draws "$one" FORMAT=svg
check 'and says what to install' says "gnuplot is missing, so no figure is drawn: 'make setup' installs it."
printf '<?xml version="1.0"?>\n<fontconfig><cachedir>%s</cachedir></fontconfig>\n' "$scratch/cache" >"$scratch/fonts.conf"
rm -f "$one/$first/$first."[sp]*
export FONTCONFIG_FILE="$scratch/fonts.conf"
check 'without a font, PNGs and PDFs are not drawn' fails draws "$one" FORMAT=svg,png,pdf THEME=light
check 'and that is reported' says 'There is no font'
check 'nor if fonts cannot be listed' fails without fc-list draws "$one" FORMAT=png
check 'no PNG without text is left' test ! -e "$one/$first/$first.png"
check 'what needs no font is drawn' cmp "$one/$first/$first.svg" "$drawn/$first/$first.svg"
unset FONTCONFIG_FILE
check 'with fonts that cannot be listed, all is drawn' without fc-list draws "$one" FORMAT=png
names=$all

finish 'figures, long'
