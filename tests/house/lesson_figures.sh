#!/bin/sh
# lesson_figures.sh - the figures in the lessons are byte for byte those that the code draws, and their words.
# The SVGs of gnuplot 5.4 and 6.0 are the same bytes.
# Only reads the tree.
set -u
. tests/house/runner/library.sh
once 'figures in the lessons' "the figures in the lessons"
. tests/house/figures/scripts.sh

needs 'figures in the lessons' "that the lessons' figures are those of the code" gnuplot
drawn=$scratch/drawn
draw() {
    scripts_into "$drawn" || return 1
    # shellcheck disable=SC2046,SC2086 # names are words
    FORMAT=svg THEME='' SHAPE=16:9,4:3 STEPS='' "$BUILD/chapters/gallery/draw_figures" "$drawn" $names &&
        FORMAT=svg THEME='' SHAPE=16:9,4:3 STEPS=1 "$BUILD/chapters/gallery/draw_figures" "$drawn" \
            $("$BUILD/tests/house/figures/lesson_figures" --in-steps chapters/[0-9]*)
}
compare() {
    "$BUILD/tests/house/figures/lesson_figures" "$@" >"$scratch/said"
}
fails() {
    ! "$@"
}
check 'the figures are drawn' draw
for chapter in chapters/[0-9]*; do
    all_is_shown() {
        compare "$drawn" "$chapter" || { cat "$scratch/said"; return 1; }
    }
    check "${chapter#chapters/} shows its figures, light and dark, wide and narrow, as the code draws them" all_is_shown
done

# A wrong file is noticed, and written again.
cp -r chapters/03-screen "$scratch/"
copy=$scratch/03-screen
echo ' ' >>"$copy/figures/pixel-grid-dark.svg"
check 'a figure of other bytes is noticed' fails compare "$drawn" "$copy"
check 'with its name' says 'pixel-grid-dark.svg is not what the code draws: make lesson-figures'
rm "$copy/figures/pixel-grid.svg"
echo ' ' >>"$copy/figures/screen-to-unit-step2.svg"
check 'a missing figure is noticed' fails compare "$drawn" "$copy"
check 'with its name also' says 'pixel-grid.svg is missing'
check 'a step of other bytes is noticed' says 'screen-to-unit-step2.svg is not what the code draws'
sed 's/ alt="[A-Z]/ alt="?/' chapters/03-screen/README.md >"$copy/README.md"
check 'other words are noticed' fails compare "$drawn" "$copy"
check 'with the name of the figure' says 'shows screen-to-unit with other words'
check 'also those of a step' says 'shows screen-to-unit-step2 with other words'
check 'all of it can be written afresh' compare --write "$drawn" "$copy"
check 'and is then what is committed' diff -r chapters/03-screen "$copy"
grep -v 'pixel-grid.svg' chapters/03-screen/README.md >"$copy/README.md"
check 'a figure that is not shown is noticed' fails compare "$drawn" "$copy"
check 'with the line that shows it' says '" src="figures/pixel-grid.svg"></picture>'
check 'and cannot be placed by a program' fails compare --write "$drawn" "$copy"
finish 'figures in the lessons'
