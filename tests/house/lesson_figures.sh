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
compare() {
    python3 -B chapters/lessons/lesson_figures.py "$@" >"$scratch/said"
}
draw() {
    scripts_into "$drawn" || return 1
    # shellcheck disable=SC2046,SC2086 # names are words
    FORMAT=svg THEME='' SHAPE='' STEPS='' python3 chapters/gallery/draw_figures.py "$drawn" $names &&
        FORMAT=svg THEME='' SHAPE='' STEPS=1 python3 chapters/gallery/draw_figures.py "$drawn" \
            $(python3 -B chapters/lessons/lesson_figures.py --in-steps chapters/[0-9]*)
}
check 'the figures are drawn' draw
for chapter in chapters/[0-9]*; do
    all_is_shown() {
        compare "$drawn" "$chapter" || { cat "$scratch/said"; return 1; }
    }
    check "${chapter#chapters/} shows its figures as the code draws them" all_is_shown
done

finish 'figures in the lessons'
