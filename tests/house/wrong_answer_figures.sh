#!/bin/sh
# wrong_answer_figures.sh - a wrong answer is drawn beside the right one: under its verdict, and in every figure.
#
# Needs gnuplot to draw and Python to read.
# Builds only below its answers.
# shellcheck disable=SC2016 # single quotes are meant literally
set -u
. tests/house/runner/library.sh
once wrong_answer_figures "the figures of wrong answers"

needs wrong_answer_figures 'yours beside right' gnuplot python3
export NO_COLOR=1
unset ANSWERS
answers=$scratch/answers
figures=build$answers/figures

marks_are_right() {
    python3 tests/house/figures/wrong_answers.py "$scratch/python"
    status=$?
    rm -rf "build$scratch/python"
    return $status
}
check 'each mark of a dozen wrong answers is where it belongs' marks_are_right

# Without gnuplot no missing file is named; pictures do not need gnuplot.
fresh() {
    rm -rf "$answers"
    mkdir -p "$answers"
    cp solutions/*.c "$answers"
}
spoil() {
    sed "$2" "solutions/$1.c" >"$answers/$1.c"
    ! cmp -s "solutions/$1.c" "$answers/$1.c"
}
mkdir "$scratch/bin"
for tool in /usr/bin/* /bin/* "$(command -v make)"; do
    [ "${tool##*/}" = gnuplot ] || ln -sf "$tool" "$scratch/bin/${tool##*/}"
done
without_gnuplot() {
    PATH=$scratch/bin make --no-print-directory exercises ANSWERS="$answers" EX="$1" >"$scratch/said" 2>&1
    cat "$scratch/said"
    grep -q 'try  ' "$scratch/said"
}
fresh
spoil 01-corners 's|c.distance \* c.forward - c.width / 2|c.distance * c.forward - c.width|'
spoil 06-ray-casting 's|if (t < depth\[i\])|if (t < NO_HIT)|'
check 'without gnuplot a vector is judged' without_gnuplot 01
check 'and no figure is promised' says_not '  see '
check 'without gnuplot a picture is judged' without_gnuplot 06
check 'and shown' says "  see        $figures/cast_object_order.png"

# ---- all figures by wrong answers -----------------------------------------------------------------

draws() {
    make --no-print-directory figures ANSWERS="$answers" FORMAT=svg THEME=light "$@" >"$scratch/said" 2>&1
    status=$?
    cat "$scratch/said"
    return $status
}
holds() {
    cat "$2"
    grep -qF -- "$1" "$2"
}
holds_not() {
    ! grep -F -- "$1" "$2"
}
is_there() {
    [ -s "$1" ]
}
is_not_there() {
    [ ! -e "$1" ]
}
check 'figures by wrong answers are drawn' draws
check 'what is wrong is dashed' holds 'stroke-dasharray' "$figures/corner-vectors/corner-vectors.svg"
check 'the mistake is named below it' holds 'upper_left looks like d f − w r + h/2 u: the whole width.' "$figures/corner-vectors/corner-vectors.txt"
check 'and in its alternative text' holds 'the whole width.' "$figures/corner-vectors/corner-vectors.svg"
calls() {
    program=build$answers/$1
    figure=$2
    shift 2
    "$program" --figure "$figure" --answers >"$scratch/said" && printf '%s\n' "$@" | diff - "$scratch/said"
}
check 'a program knows which answers a figure calls' calls 01-corners point-30-10 image_plane_vector across_30_up_10
check 'and those that its answers call in other chapters' calls 04-pixel-ray pixel-to-ray \
    pixel_center screen_to_normalized pixel_ray image_plane_vector
check 'a figure that is right says nothing of it' holds 'wrong = 0' "$figures/yours-and-right/yours-and-right.gp"
check 'nor of the mistake' holds_not 'whole width' "$figures/yours-and-right/yours-and-right.svg"

spoil 01-corners 's|c.distance \* c.forward - c.width / 2|0.0 / 0 * c.forward - c.width / 2|'
check 'what is not a number stops no figure' draws
check 'it is not drawn' is_there "$figures/corner-vectors/corner-vectors.svg"
check 'but known to be wrong' holds 'wrong = 1' "$figures/corner-vectors/corner-vectors.gp"

spoil 01-corners 's|return image_plane_vector(c, 0.3, 0.1)|return *(vec3 *)16|'
of_01=FIGURE=$(basename -s .gp -a chapters/01-corners/figures/*.gp | paste -sd ,)
check 'a crash stops no other figure' draws "$of_01"
check 'it is reported in one line' says "not yet   $figures/yours-and-right: "
check 'and nothing older is left of it' is_not_there "$figures/yours-and-right/yours-and-right.svg"
check 'the others are drawn' is_there "$figures/corner-vectors/corner-vectors.svg"

cp build/blanks/01-corners.c "$answers"
check 'a blank stops no other figure' draws "$of_01"
check 'the missing answer is reported in one line' says "not yet   $figures/corner-vectors: needs image_plane_vector"

# Other words for the same number, and other digits of 0, are not a difference.
fresh
spoil 01-corners 's|c.height / 2 \* c.up;|0.5 * (c.height + 1e-13) * c.up + vec3_of(1e-17, 0, 1e-16);|'
check 'a figure by right answers is drawn' draws FIGURE=corner-vectors
check 'a rounding error is not a difference' holds 'wrong = 0' "$figures/corner-vectors/corner-vectors.gp"

# A picture is shown beside the right one, and rounding is not a difference here either.
spoil 07-shading 's|ks \* pow(cosine, shine)|ks * exp(shine * log(cosine))|'
check 'a picture by right answers is drawn' draws FIGURE=flat-and-shaded
check 'other digits of its light are not a difference' holds 'wrong = 0' "$figures/flat-and-shaded/flat-and-shaded.gp"
check 'it is flat and shaded' holds 'Left, flat' "$figures/flat-and-shaded/flat-and-shaded.txt"
spoil 07-shading 's|pow(cosine, shine)|pow(cosine, 0.9 * shine)|'
check 'a picture by wrong answers is drawn' draws FIGURE=flat-and-shaded
check 'larger highlights are a difference' holds 'wrong = 1' "$figures/flat-and-shaded/flat-and-shaded.gp"
check 'both pictures are there' holds '$your_shaded << EOD' "$figures/flat-and-shaded/flat-and-shaded.gp"
check 'and are named' holds 'shaded: left with right answers, right with yours.' "$figures/flat-and-shaded/flat-and-shaded.txt"
check 'nothing is said to be dashed' holds_not 'dashed' "$figures/flat-and-shaded/flat-and-shaded.txt"

# The same figure with more rows, with fewer and with none.
other_rows() {
    cp "$PROGRAMS/01-corners" "$scratch/program" && "$scratch/program" --figure corner-vectors >"$scratch/right.gp" &&
        awk "$1" "$scratch/right.gp" >"$scratch/changed.gp" && ! cmp -s "$scratch/right.gp" "$scratch/changed.gp" &&
        "$scratch/program" --figure corner-vectors --beside "$scratch/changed.gp" \
            --note '"`touch hacked`" \ %s @see _^{}' >"$scratch/both.gp" &&
        grep -q '^wrong = 1' "$scratch/both.gp" &&
        for format in svg txt png pdf; do
            (cd "$scratch" && LC_ALL=C.UTF-8 gnuplot -e "format='$format'; output='both'" both.gp 2>&1) >"$scratch/words"
            [ ! -s "$scratch/words" ] || { cat "$scratch/words"; return 1; }
        done
}
check 'more rows than are right are drawn' other_rows '/^\$grid/ { print; getline; print; getline; next } { print }'
check 'fewer rows than are right are drawn' other_rows '/^\$grid/ { print; getline; print; print "1 2 3"; next } { print }'
check 'no rows in place of some are drawn' other_rows \
    '/^\$upper_left/ { print; getline; print; getline; print "1e9 1e9 1e9 1e9 1e9 1e9"; next } { print }'
check 'no word of a mistake runs as a command' is_not_there "$scratch/hacked"
check 'it is shown as it is' holds "\"'touch hacked'\" \\ %s @see _^{}" "$scratch/both.txt"

rm -rf "${answers:?}" "build$answers"
finish wrong_answer_figures
