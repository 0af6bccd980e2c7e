#!/bin/sh
# mistaken_figures.sh - the deck's figures with a known mistake in the place of a right answer: each is drawn, and nothing
# of it is off its canvas.
#
# MISTAKES says which are tried: every 100th; 1 is all of them (tests/proof/mistaken_figures.sh).
# Only reads the tree.
set -u
. tests/house/runner/library.sh
once mistaken_figures "figures of known mistakes"
needs mistaken_figures 'figures of known mistakes' gnuplot python3

export MISTAKES="${MISTAKES:-100}" PYTHONPATH=tests/house/figures
for layout in chapters/0[1-7]-*/figures/*.gp; do
    echo "$(basename "$(dirname "$(dirname "$layout")")") $(basename "$layout" .gp)"
done >"$scratch/figures"
# Each figure begins with another mistake. The shaded picture takes seconds, so few of them are cast.
scripts_of() {
    number=0
    while read -r stem name; do
        every=$MISTAKES
        if [ "$name" = flat-and-shaded ]; then
            [ "$MISTAKES" -eq 1 ] || continue
            every=100
        fi
        "$BUILD/tests/mistaken/$stem" "$name" "$scratch" "$every" $((number % every)) || return 1
        number=$((number + 7))
    done <"$scratch/figures" >"$scratch/scripts" 2>"$scratch/said"
}
check 'the programs print the figures' scripts_of
# A figure has none if its answers end the program or refuse its camera: it says so.
counted python3 tests/house/figures/mistaken.py <"$scratch/scripts"
finish mistaken_figures
