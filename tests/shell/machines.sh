#!/bin/sh
# machines.sh - other machines: locales, awks, names of folders, trees that cannot be written.
# Only reads the tree.
set -u
. tests/library.sh

# ---- locales ------------------------------------------------------------------------------------

script=$scratch/figure.gp
"$PROGRAMS/05-quadratic" --figure parabola >"$script"
draws_in() {
    (cd "$scratch" && LC_ALL=$1 gnuplot -e "output='$1'" figure.gp >"$scratch/said" 2>&1) && [ -s "$scratch/$1.svg" ]
}
# gnuplot 6 says nothing, and earlier ones nothing but this.
no_other_word() {
    grep -v 'iconv failed to convert degree sign' "$scratch/said"
    [ $? -eq 1 ] && { [ ! -s "$scratch/said" ] || gnuplot --version | grep -q 'gnuplot [1-5]\.'; }
}
if command -v gnuplot >/dev/null; then
    check 'gnuplot draws a figure' draws_in C.UTF-8
    check 'and in locale C, too' draws_in C
    check 'without a word that matters' no_other_word
    check 'the same bytes' cmp "$scratch/C.svg" "$scratch/C.UTF-8.svg"
else
    echo "skipped: figures in locale C: gnuplot is missing ('make setup' installs it)"
fi
finish machines
