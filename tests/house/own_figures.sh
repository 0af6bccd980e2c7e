#!/bin/sh
# own_figures.sh - make figures FIGURES=folder: the example of chapters/README.md, and what is refused.
# Builds only below its answers.
set -u
. tests/house/runner/library.sh
once own_figures "a lecturer's own figures"

needs own_figures "a lecturer's own figures" gnuplot
unset ANSWERS
# The page's folder is in another place here, and so are its answers, for the figures of this test alone.
own=$scratch/my-figures
answers=$scratch/answers
figures=build$answers/figures
mkdir "$answers"
cp solutions/*.c "$answers"
# The lines of the page between ```KIND and ```, of the only such block that has this word.
page() {
    awk -v begin="\`\`\`$1" -v word="$2" '$0 == begin { inside = 1; text = ""; next }
        $0 == "```" { if (inside && index(text, word)) printf "%s", text; inside = 0 }
        inside { text = text $0 "\n" }' chapters/README.md
}
# All of its figures, or the one that is named.
draws() {
    make --no-print-directory figures ANSWERS="$answers" FIGURES="$own" FORMAT=svg FIGURE="$1" >"$scratch/said" 2>&1
    status=$?
    cat "$scratch/said"
    return $status
}
fails() {
    ! draws ''
}
holds() {
    cat "$2"
    grep -qF -- "$1" "$2"
}

page sh my-figures | sed "s|FIGURES=my-figures|& ANSWERS=$answers FORMAT=svg|; s|my-figures|$own|g" >"$scratch/commands"
check 'the commands of the page are there' grep -q 'make figures FIGURES=' "$scratch/commands"
check 'they draw a figure' sh -e "$scratch/commands"
check 'with numbers of its own' holds "f(0) is 15.25" "$figures/half-way-up/half-way-up.txt"
check 'and no other' test ! -e "$figures/parabola"

page c figure_data >"$own/shape.c"
page gnuplot shape.c >"$own/shape.gp"
check 'numbers in C are drawn' draws ''
check 'both figures are counted' says "Figures: 2 as svg in $figures/"
# Height i/10: the hit is at x = -sqrt(1 - y * y).
hits_are_on_the_circle() {
    awk '/^\$rays << EOD/ { inside = 1; next } /^EOD/ { inside = 0 }
        inside && /^[^#]/ { rows++; x = $1 + $4; y = $2 + $5; if (x > 0 || (x * x + y * y - 1) ^ 2 > 1e-20) bad = 1 }
        END { exit bad || rows != 19 }' "$figures/shape/shape.gp"
}
check 'they are those of the answers' hits_are_on_the_circle
check 'in words also' holds 'Parallel rays find the shape of a sphere' "$figures/shape/shape.txt"
check 'a dark one is beside it' test -s "$figures/shape/shape-dark.svg"
check 'one of them can be chosen' draws shape
check 'it is not drawn again' says "Figures: 1 as svg in $figures/ (0 drawn now)"

# Errors name the file, the line, and what was expected.
sed -i 's/^plot/plot no_such_number,/' "$own/shape.gp"
check 'a mistake in a layout is an error' fails
check 'at its line' says "$own/shape.gp:6: gnuplot: undefined variable: no_such_number"
refused() {
    printf '%s\n' "$1" >"$own/shape.gp"
    fails && says "$2"
}
check 'a layout that names no numbers is refused' refused 'plot 1' "$own/shape.gp:1: expected '# data: FIGURE'"
check 'so is a figure that does not exist' refused '# data: parabole' \
    "$own/shape.gp:1: no figure 'parabole', expected one of camera-forms"
check 'so is a source that does not exist' refused '# data: form.c' "$own/shape.gp:1: no form.c in $own"
check 'so is an option that does not exist' refused '# data: parabola --orign 1,2,3' "'--orign' is not an option"
check 'with the line that has it' says "$own/shape.gp:1: its data could not be computed"
check 'no option runs as a command' refused "# data: parabola ; touch $scratch/hacked" 'its data could not be computed'
check 'whatever it is' test ! -e "$scratch/hacked"
mv "$own/shape.gp" "$own/parabola.gp"
check 'the name of a figure of the toolkit is taken' fails
check 'and that is said' says "$own/parabola.gp: a chapter has a figure of this name, expected another one"
own=$scratch/nothing
check 'a folder that does not exist is refused' fails
check 'by its name' says "FIGURES=$own: no such folder"
mkdir "$own"
check 'so is one without a layout' fails
check 'with what was expected' says "FIGURES=$own: no figure in it, expected a layout NAME.gp"
own="$scratch/my figures"
check 'so is a path with a blank' fails
check 'for that reason' says 'expected one folder, whose path has no blank'

rm -rf "build$answers"
finish own_figures
