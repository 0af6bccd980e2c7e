#!/bin/sh
# slides.sh - the lecture, beside the deck that it follows; and every figure and step as LaTeX takes it in.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once slides "slides"

if ! command -v gnuplot >/dev/null; then
    skip slides "slides, which need gnuplot (make setup)"
fi
said() {
    "$@" >"$scratch/said" 2>&1
    status=$?
    cat "$scratch/said"
    return $status
}
fails() {
    ! said "$@"
}
check 'without LaTeX it fails' fails without pdflatex chapters/make_slides --ready
check 'and says what to install' says "LaTeX lacks pdflatex: 'make setup FOR=lecturer' installs it."
if ! chapters/make_slides --ready >/dev/null 2>&1; then
    skip slides "slides, which need LaTeX with Beamer (make setup FOR=lecturer)"
fi
command -v pdfinfo >/dev/null || skip slides "the pages of slides, which need poppler-utils (make setup FOR=contributor)"

drawn=$scratch/figures
check 'every figure has a script' scripts_into "$drawn"
draw() {
    # shellcheck disable=SC2086 # names are words
    env "$@" python3 chapters/gallery/draw_figures.py "$drawn" $names
}
# In CI light slides of 16:9 and the questions must do.
shapes='16:9 4:3'
[ -z "${CI:-}" ] || shapes=16:9
check 'every figure is drawn for LaTeX' draw FORMAT=tex "SHAPE=$(echo "$shapes" | tr ' ' ,)" STEPS=1 "THEME=${CI:+light}"

# ---- the lecture -------------------------------------------------------------------------------
lecture=$scratch/lecture
mkdir "$lecture"
cp "$PROGRAMS/slides/numbers.tex" "$lecture"
# lecture_as NAME SHAPE THEME VERSION: $lecture/NAME.pdf, and its text in NAME.xml.
lecture_as() {
    chapters/make_slides chapters/slides.tex "$lecture/$1.pdf" "$drawn" "$2" "$3" "$4" &&
        text_of "$1"
}
text_of() {
    pdftohtml -xml -i -zoom 10 -stdout "$lecture/$1.pdf" >"$lecture/$1.xml"
}
# tells QUESTION NAME FILE: the answer (tests/proof/slides/pages.py) is this file's.
tells() {
    python3 tests/proof/slides/pages.py "$1" <"$lecture/$2.xml" >"$scratch/told" && diff "$scratch/told" "$3"
}
: >"$scratch/nothing"
# Title for title, the deck.
cat >"$scratch/deck" <<'DECK'
Ray Tracing, Part I
Readings
Ray Traced Images Achieve Maximal Realism
Two ways of rendering a picture: object order
Two ways of rendering a picture: image order
Ray casting, a simplified ray tracing
Camera
Finding vectors from the eye to the image plane
Other camera representations
Normalized screen coordinates
Mapping from Pixel to Camera Ray
Ray casting process
Intersecting a ray and a sphere
Solving quadratic
Intersecting a ray and a sphere
Still something missing . . .
DECK
no_complaints() {
    grep -q 'Output written' "$lecture/.work/$1/$1.log" && ! grep -E 'Overfull|Missing character|LaTeX Warning: (Unused|File)|undefined' "$lecture/.work/$1/$1.log"
}
# shows_all_steps NAME SUFFIX: each step of each figure of the lecture is on a page.
shows_all_steps() {
    grep -q "/corner-vectors-step1$2\.tex" "$lecture/.work/$1/$1.log" || return 1
    status=0
    for name in $names; do
        grep -q "/$name-step1$2\.tex" "$lecture/.work/$1/$1.log" || continue
        for step in "$drawn/$name/$name"-step[0-9]"$2".tex; do
            grep -qF "/${step##*/}" "$lecture/.work/$1/$1.log" || { echo "$step"; status=1; }
        done
    done
    return $status
}
# Each name is a function of the chapter whose number is before it.
are_exercises() {
    python3 tests/proof/slides/pages.py exercises <"$lecture/$1.xml" >"$scratch/exercises" || return 1
    ! grep 'none' "$scratch/exercises" || return 1
    status=0
    while IFS=' ,:' read -r word chapter functions; do
        [ "$word" = Exercise ] || continue
        for name in $(echo "$functions" | tr -d ','); do
            grep -q "EXERCISE(\"$chapter-[^\"]*\",[^,]*, $name," tests/exercises.def || { echo "$chapter $name"; status=1; }
        done
    done <"$scratch/exercises"
    return $status
}
is_of_size() {
    pdfinfo "$lecture/$1.pdf" | grep -F "$2"
}
# The colour of the last pixel of a page that has only words, in bytes. (The very edge of the paper may be lighter.)
has_ground() {
    pdftoppm -r 10 -x 2 -y 2 -W 10 -H 3 -f 2 -l 2 "$lecture/$1.pdf" | tail -c 3 | od -An -tu1 | grep -qx " *$2 *$3 *$4"
}
for shape in $shapes; do
    case $shape in
    16:9) at=wide paper='453.543 x 255.118 pts' ;;
    *) at=narrow paper='340.157 x 255.118 pts' ;;
    esac
    check "the slides are made, $shape" lecture_as $at "$shape" light slides
    check "their titles are the deck's, in its order, $shape" tells titles $at "$scratch/deck"
    check "each page names an exercise that exists, $shape" are_exercises $at
    check "nothing is too wide, too high or missing, $shape" no_complaints $at
    check "the paper has that shape, $shape" is_of_size $at "$paper"
done
check 'each figure grows, step by step' shows_all_steps wide ''
comes_before() {
    pdftotext "$lecture/wide.pdf" - | grep -oF -e "$1" -e "$2" >"$scratch/order"
    [ "$(head -n 1 "$scratch/order")" = "$1" ] && grep -qxF -- "$2" "$scratch/order"
}
check "the sphere's figure shows its hits after the question" comes_before 'Equation to solve?' 'is the hit'
check 'they are light' has_ground wide 255 255 255
contains() {
    pdftotext "$lecture/$1.pdf" - | tr '\n' ' ' | grep -qF -- "$2"
}
lacks() {
    [ -s "$lecture/$1.pdf" ] && ! contains "$@"
}
check 'a handout of questions alone is made' lecture_as questions 16:9 light questions
check 'on sheets of A4' is_of_size questions A4
answers='a depth buffer
its direction stays
30% across, 10% up =
It has no distance
each gives
not sizes but places
Solve for
Much simpler in object coordinates
world:
is the hit
which way the surface faces'
questions='were all doubled?
upper left corner.
normalized screen coordinates?
Equation to solve?'
# each CONTAINS-OR-LACKS NAME LINES
each() {
    echo "$3" >"$scratch/lines"
    while IFS= read -r line; do
        "$1" "$2" "$line" || { echo "$line"; return 1; }
    done <"$scratch/lines"
}
check 'it has the questions' each contains questions "$questions"
check 'and no answer' each lacks questions "$answers"
frames_of() {
    grep inserttotalframenumber "$lecture/.work/$1/$1.nav"
}
are_as_many() {
    frames_of wide && [ "$(frames_of questions)" = "$(frames_of wide)" ]
}
check 'its slides have the numbers of the projected ones' are_as_many
if [ -n "${CI:-}" ]; then
    echo "skipped: dark slides, the handout with answers, notes, 4:3 and slides of one's own (CI)"
    finish slides
    exit
fi
check 'a handout with answers is made' lecture_as handout 16:9 light handout
check 'it has the questions' each contains handout "$questions"
check 'and the answers' each contains handout "$answers"
check 'dark slides are made' lecture_as dark 16:9 dark slides
check 'and are dark' has_ground dark 22 25 29
check 'also with all steps' shows_all_steps dark -dark

check 'the notes are made' lecture_as notes 16:9 light notes
check 'beside the slides' is_of_size notes '907.087 x 255.118 pts'
check 'there are notes on every page' tells notes notes "$scratch/nothing"
check 'nothing is too high for the notes' no_complaints notes
check 'they say what the deck leaves out' contains notes 'The deck leaves out:'
check 'and what we correct' contains notes 'Our correction: the red vector that the deck draws ends at'
check 'nobody else sees them' lacks wide 'Our correction:'

# The vectors of a turned camera are long.
long=$scratch/long
mkdir "$long"
vector='{(-0.6846, -0.7287, -0.01688)}'
sed -E "s/^(.newcommand.ex(Eye|Right|Up|Forward))\{.*/\\1$vector/" "$lecture/numbers.tex" >"$long/numbers.tex"
fits_long_numbers() {
    [ "$(grep -cF -e "$vector" "$long/numbers.tex")" -eq 4 ] &&
        chapters/make_slides chapters/slides.tex "$long/turned.pdf" "$drawn" "$1" light slides &&
        ! grep Overfull "$long/.work/turned/turned.log"
}
check 'long numbers are not too wide' fits_long_numbers 16:9
check 'also in 4:3' fits_long_numbers 4:3

# Text is 24 of 540 units high or larger.
for shape in 16:9 4:3; do
    check "slides and notes for the last row are made, $shape" lecture_as last $shape light notes
    check "no text is too small, $shape" tells small last "$scratch/nothing"
done

again=$scratch/again
mkdir "$again"
cp "$lecture/numbers.tex" "$again"
cp -r "$drawn" "$scratch/figures-again"
check 'slides are made once more, elsewhere' chapters/make_slides chapters/slides.tex "$again/wide.pdf" "$scratch/figures-again" 16:9 light slides
check 'and have the same bytes' cmp "$lecture/wide.pdf" "$again/wide.pdf"

# ---- slides of one's own -------------------------------------------------------------------------
# A folder of its own, with all that 'make figures FORMAT=tex' made: every file on a page.
talk=$scratch/talk
mkdir "$talk"
cp "$drawn"/*/*.tex "$drawn"/*/*-tex.pdf chapters/slides/lecture.sty "$talk"
{
    printf '%s\n' '\documentclass[t]{beamer}' '\usepackage{lecture}' '\begin{document}'
    for file in "$drawn"/*/*.tex; do
        printf '\\begin{frame}[plain]\\centering\\resizebox{!}{\\textheight}{\\input{%s}}\\end{frame}\n' "${file##*/}"
    done
    printf '%s\n' '\end{document}'
} >"$talk/talk.tex"
compiles() {
    (cd "$talk" && pdflatex -interaction=nonstopmode -halt-on-error "$1") >"$scratch/log" 2>&1
    status=$?
    grep -A 6 '^!' "$scratch/log"
    return $status
}
check 'a folder that is copied holds all that its figures need' compiles talk
complains_not() {
    ! grep -E 'Missing character|LaTeX Warning: (Unused|File)|undefined' "$talk/talk.log"
}
check 'no letter is missing' complains_not

printf '%s\n' '\documentclass{beamer}' '\usepackage{lecture}' '\begin{document}' \
    '\topic{Mine}{\exercise{05}{hit\_sphere}}' '\figureframe{parabola}{1}{A note.}' '\end{document}' >"$talk/mine.tex"
check "slides of one's own are made" chapters/make_slides "$talk/mine.tex" "$lecture/mine.pdf" "$drawn" 16:9 light slides
pages() {
    pdfinfo "$lecture/$1.pdf" | sed -n 's/^Pages: *//p'
}
steps=$(find "$drawn/parabola" -name 'parabola-step[0-9].tex' | wc -l)
check 'with a page for each step' test "$(pages mine)" -eq "$steps"
check 'LaTeX alone makes them, where the figures are beside them' compiles mine
by_the_page() {
    commands=$(sed -n 's/^cd my-talk && //p' chapters/README.md | sed 's/talk/mine/g')
    rm -f "$talk"/mine*.pdf
    (cd "$talk" && sh -c "$commands" </dev/null) && cp "$talk/mine.pdf" "$talk/mine-dark.pdf" "$lecture"
}
check "the page's commands make two of them" by_the_page
check 'a light one' has_ground mine 255 255 255
check 'and a dark one' has_ground mine-dark 22 25 29

# A figure of one's own, on slides of one's own. Its answers and its output are in a place of their own.
mkdir "$scratch/my-figures" "$scratch/answers"
cp solutions/*.c "$scratch/answers"
{
    echo '# data: parabola --origin -4,0.5,0 --direction 1,0,0'
    cat chapters/05-quadratic/figures/parabola.gp
} >"$scratch/my-figures/half-way-up.gp"
sed 's/parabola/half-way-up/' "$talk/mine.tex" >"$scratch/own.tex"
with_own_figures() {
    (unset MAKEFLAGS; make --no-print-directory slides "SLIDES=$scratch/own.tex" "FIGURES=$scratch/my-figures" "ANSWERS=$scratch/answers")
}
check "a folder of one's own figures is used" with_own_figures
shows_own_figure() {
    pdfinfo "build$scratch/answers/slides/own.pdf" | grep -qx "Pages: *$steps" &&
        pdftotext "build$scratch/answers/slides/own.pdf" - | grep -F '15.25'
}
check 'with all its steps and its numbers' shows_own_figure
rm -rf "build$scratch"

printf '\\documentclass{beamer}\n\\begin{document}\n\\nosuchcommand\n\\end{document}\n' >"$scratch/wrong.tex"
check 'a LaTeX error is a failure' fails chapters/make_slides "$scratch/wrong.tex" "$lecture/wrong.pdf" "$drawn" 16:9 light slides
check 'and is shown' says 'nosuchcommand'
check 'by no picture that is left' test ! -e "$lecture/wrong.pdf"
without_slides() {
    make --no-print-directory slides SLIDES=none.tex
}
check 'SLIDES that is not there is an error' fails without_slides
check 'and is named' says 'SLIDES=none.tex: no such file'

finish slides
