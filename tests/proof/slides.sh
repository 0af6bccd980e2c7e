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
make_slides() {
    QUESTIONS=$BUILD/questions/questions.txt python3 chapters/slides/make_slides.py "$@"
}
without_latex() {
    env "PATH=$scratch/no-latex" python3 chapters/slides/make_slides.py --ready
}
mkdir "$scratch/no-latex" && ln -s "$(python3 -c 'import sys; print(sys.executable)')" "$scratch/no-latex/python3"
check 'without LaTeX it fails' fails without_latex
check 'and says what to install' says "LaTeX lacks pdflatex: 'make setup FOR=lecturer' installs it."
if ! make_slides --ready >/dev/null 2>&1; then
    skip slides "slides, which need LaTeX with Beamer (make setup FOR=lecturer)"
fi
command -v pdfinfo >/dev/null || skip slides "the pages of slides, which need poppler-utils (make setup FOR=contributor)"

drawn=$scratch/figures
check 'every figure has a script' scripts_into "$drawn"
draw() {
    # shellcheck disable=SC2086 # names are words
    env FORMAT=tex STEPS=1 "THEME=${CI:+light}" "$@" python3 chapters/gallery/draw_figures.py "$drawn" $names
}
check 'every figure is drawn for LaTeX' draw SHAPE=16:9,4:3

# ---- the lecture -------------------------------------------------------------------------------
lecture=$scratch/lecture
mkdir "$lecture"
cp "$PROGRAMS/slides/numbers.json" "$lecture"
# lecture_as NAME SHAPE THEME: $lecture/NAME.pdf, and its text in NAME.xml; paper NAME SHAPE VERSION: NAME-VERSION.pdf
lecture_as() {
    make_slides chapters/slides.txt "$lecture/numbers.json" "$drawn" "$2" "$3" "$lecture/$1.pdf" && text_of "$1"
}
paper() {
    make_slides chapters/slides.txt "$lecture/numbers.json" "$lecture/$1.pdf" "$2" "$3" "$lecture/$1-$3.pdf" && text_of "$1-$3"
}
text_of() {
    pdftohtml -xml -i -zoom 10 -stdout "$lecture/$1.pdf" >"$lecture/$1.xml"
}
# tells QUESTION NAME FILE: the answer (tests/proof/slides/pages.py) is this file's.
tells() {
    python3 tests/proof/slides/pages.py "$1" <"$lecture/$2.xml" >"$scratch/told" && diff "$scratch/told" "$3"
}
: >"$scratch/nothing"
# Title for title, the deck; and after a + what is added between its slides.
sed 's/^+ //' >"$scratch/deck" <<'DECK'
Ray Tracing, Part I
Readings
Ray Traced Images Achieve Maximal Realism
+ From a pixel to its color
Two ways of rendering a picture: object order
Two ways of rendering a picture: image order
Ray casting, a simplified ray tracing
+ Which line was it?
Camera
Finding vectors from the eye to the image plane
Other camera representations
+ Which line was it?
Normalized screen coordinates
Mapping from Pixel to Camera Ray
Ray casting process
+ Which line was it?
Intersecting a ray and a sphere
Solving quadratic
Intersecting a ray and a sphere
+ Which line was it?
Still something missing . . .
+ Which line was it?
+ What you can write now
DECK
no_complaints() {
    log=$lecture/.work/$1/$1.log
    grep -q 'Output written' "$log" && ! grep -E 'Overfull|Missing character|LaTeX Warning: (Unused|File)|undefined' "$log"
}
pages() {
    pdfinfo "$lecture/$1.pdf" | sed -n 's/^Pages: *//p'
}
# Each name is a function of the chapter whose number is before it.
are_exercises() {
    python3 tests/proof/slides/pages.py exercises <"$lecture/$1.xml" >"$scratch/exercises" || return 1
    status=0
    grep -v ^Exercises "$scratch/exercises" >"$scratch/of-chapters"
    while IFS=' ,:' read -r _ chapter functions; do
        for name in $(echo "${functions%% ·*}" | tr -d ','); do
            grep -q "EXERCISE(\"$chapter-[^\"]*\",[^,]*, $name," tests/exercises.def || { echo "$chapter $name"; status=1; }
        done
    done <"$scratch/of-chapters"
    [ -s "$scratch/exercises" ] && return $status
}
is_of_size() {
    pdfinfo "$lecture/$1.pdf" | grep -F "$2"
}
# The color of the last pixel of a page that has only words, in bytes. (The very edge of the paper may be lighter.)
has_ground() {
    pdftoppm -r 10 -x 2 -y 2 -W 10 -H 3 -f 2 -l 2 "$lecture/$1.pdf" | tail -c 3 | od -An -tu1 | grep -qx " *$2 *$3 *$4"
}
slides=$(grep -c '^= ' chapters/slides.txt)
at_most_100() {
    pages "$1"
    [ "$slides" -eq 39 ] && [ "$(pages "$1")" -le 100 ]
}
are_numbered() {
    python3 tests/proof/slides/pages.py places <"$lecture/$1.xml" | uniq >"$scratch/places"
    number=0
    while [ $((number += 1)) -le "$slides" ]; do echo "$number of $slides"; done | diff - "$scratch/places"
}
for shape in 16:9 4:3; do
    case $shape in
    16:9) at=wide paper='453.543 x 255.118 pts' ;;
    *) at=narrow paper='340.157 x 255.118 pts' ;;
    esac
    check "the slides are made, $shape" lecture_as $at "$shape" light
    check "their titles are the deck's, in its order, $shape" tells titles $at "$scratch/deck"
    check "39 slides have at most 100 pages, $shape" at_most_100 $at
    check "each page says which slide it is, of how many, $shape" are_numbered $at
    check "nothing is too wide, too high or missing, $shape" no_complaints $at
    check "the paper has that shape, $shape" is_of_size $at "$paper"
done
# The codes for phones, if the address of the site is known. They are links as well.
has_codes() {
    ADDRESS=https://example.org/a/ lecture_as coded 16:9 light && no_complaints coded || return
    pdfinfo -url "$lecture/coded.pdf" | grep -o 'https://example.org.*' | uniq | diff - "$scratch/codes"
}
has_no_codes() {
    ! pdfinfo -url "$lecture/wide.pdf" | grep html'#'
}
python3 - chapters/slides.txt >"$scratch/codes" <<'CODES'
import re, sys
for slide in open(sys.argv[1], encoding="utf-8").read().split("\n= "):
    figure = re.search(r"^figure: (\S+)", slide, re.M)
    if re.search("^code$", slide, re.M):
        print("https://example.org/a/" + (f"figures.html#{figure[1]}" if figure else "index.html"))
CODES
check "codes lead to the figures' addresses" has_codes
check 'without an address there are none' has_no_codes
check 'each exercise that a page names is there' are_exercises wide
check 'no text is too small' tells small wide "$scratch/nothing"
check 'the PDF has a title' is_of_size wide 'Ray Tracing, Part I'
# What a page shows first of a slide and what it shows later.
comes_before() {
    pdftotext "$lecture/wide.pdf" - | grep -oF -e "$1" -e "$2" >"$scratch/order"
    [ "$(head -n 1 "$scratch/order")" = "$1" ] && grep -qxF -- "$2" "$scratch/order"
}
check "the sphere's figure shows its hits after the question" comes_before 'Equation to solve?' 'is the hit'
# The question and its figure are on one page.
are_together() {
    for page in $(seq "$(pages wide)"); do
        pdftotext -f "$page" -l "$page" "$lecture/wide.pdf" - >"$scratch/page"
        ! { grep -qF -- "$1" "$scratch/page" && grep -qF -- "$2" "$scratch/page"; } || return 0
    done
    return 1
}
check 'a question and its figure are on one page' are_together 'remember?' 'eye'
check 'they are light' has_ground wide 255 255 255
contains() {
    pdftotext "$lecture/$1.pdf" - | tr '\n' ' ' | grep -qF -- "$2"
}
lacks() {
    [ -s "$lecture/$1.pdf" ] && ! contains "$@"
}
check 'a handout with answers is made' paper wide 16:9 handout
check 'on sheets of A4' is_of_size wide-handout A4
check 'two slides on each' test "$(pages wide-handout)" -eq $(((slides + 1) / 2))
check 'it has the answers' contains wide-handout 'a depth buffer'
check 'a handout of questions is made' paper wide 16:9 questions
before_answers() {
    pdftotext "$lecture/wide-questions.pdf" - | tr '\n' ' ' | sed 's/Answers.*//' >"$scratch/asked"
    grep -qF -- "$1" "$scratch/asked"
}
after_questions() {
    ! before_answers "$1" && contains wide-questions "$1"
}
check 'it has the questions' before_answers 'Equation to solve?'
check 'also those that come after an answer' before_answers 'And for any place'
for answer in 'depth buffer' 'its direction stays' 'the handedness of the world' 'not sizes but places' 'Solve for' \
    'Much simpler in' 'is the hit' 'how the surface scatters'; do
    check "'$answer' is among the answers at its end" after_questions "$answer"
done
check 'the notes are made' paper wide 16:9 notes
check 'beside the slides' is_of_size wide-notes '907.087 x 255.118 pts'
check 'there are notes on every page' tells notes wide-notes "$scratch/nothing"
check 'as many as slides have pages' test "$(pages wide-notes)" -eq "$(pages wide)"
check 'nothing is too high for the notes' no_complaints wide-notes
check 'they say what the deck leaves out' contains wide-notes 'The deck leaves out:'
check 'and what we correct' contains wide-notes 'Our correction: the red vector that the deck draws ends at'
check 'how long it takes, and what comes next' contains wide-notes 'Next: Two ways of rendering'
check 'nobody else sees them' lacks wide 'Our correction:'
if [ -n "${CI:-}" ]; then
    echo "skipped: dark slides, long numbers and slides of one's own (CI)"
    finish slides
    exit
fi
check 'dark slides are made' lecture_as dark 16:9 dark
check 'and are dark' has_ground dark 22 25 29

# The vectors of a turned camera are long.
fits_long_numbers() {
    vector='(-0.6846, -0.7287, -0.01688)'
    sed -E "s/(\"(eye|right|up|forward)\": \")[^\"]*/\\1$vector/g" "$lecture/numbers.json" >"$scratch/long.json"
    [ "$(grep -oF -e "$vector" "$scratch/long.json" | wc -l)" -eq 4 ] &&
        make_slides chapters/slides.txt "$scratch/long.json" "$drawn" "$1" light "$lecture/turned.pdf" && no_complaints turned
}
check 'long numbers are not too wide' fits_long_numbers 16:9
check 'also in 4:3' fits_long_numbers 4:3

mkdir "$scratch/again"
cp -r "$drawn" "$scratch/figures-again"
check 'slides are made once more, elsewhere' make_slides chapters/slides.txt "$lecture/numbers.json" "$scratch/figures-again" 16:9 light "$scratch/again/wide.pdf"
check 'and have the same bytes' cmp "$lecture/wide.pdf" "$scratch/again/wide.pdf"

# ---- figures in LaTeX of one's own, and slides of one's own ----------------------------------------
# A folder of its own, with all that 'make figures FORMAT=tex' made: every file on a page.
talk=$scratch/talk
mkdir "$talk"
cp "$drawn"/*/*.tex "$drawn"/*/*-tex.pdf "$talk"
{
    printf '%s\n' '\documentclass[t]{beamer}' '\usepackage{lmodern,amsmath,graphicx,color}' '\begin{document}'
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

# The text of the lecturer's page, and its figure of one's own. Answers and output are in a place of their own.
fence="[\`]\{3\}"
sed -n "/^${fence}text\$/,/^$fence\$/{/^$fence/d;p}" chapters/README.md >"$scratch/talk.txt"
mkdir "$scratch/my-figures" "$scratch/answers"
cp solutions/*.c "$scratch/answers"
{
    echo '# data: parabola --origin -4,0.5,0 --direction 1,0,0'
    cat chapters/05-quadratic/figures/parabola.gp
} >"$scratch/my-figures/half-way-up.gp"
own_slides() {
    (unset MAKEFLAGS; make --no-print-directory slides "SLIDES=$scratch/talk.txt" "FIGURES=$scratch/my-figures" "ANSWERS=$scratch/answers")
}
check "the page's slides of one's own are made" own_slides
shows_own_figure() {
    pdftotext "build$scratch/answers/slides/talk.pdf" - | grep -F '15.25'
}
check 'with a figure of their own and its numbers' shows_own_figure
# What is wrong is named, with its line.
wrong_slides() {
    sed "$1" "$scratch/talk.txt" >"$scratch/wrong.txt"
    (unset MAKEFLAGS; make --no-print-directory slides "SLIDES=$scratch/wrong.txt" "FIGURES=$scratch/my-figures" "ANSWERS=$scratch/answers")
}
check 'a figure that is not there is an error' fails wrong_slides 's/half-way-up/nothing/'
check 'and is named' says 'no figure nothing, expected one of half-way-up'
check 'a slide without a name is an error' fails wrong_slides '/^name/d'
check 'and is named, with its line' says "wrong.txt:4: 'Half way up' has no name"
check 'a step that is not there is an error' fails wrong_slides 's/^answer.*/answer 9/'
check 'and is named, with its slide' says "has no step 9: slide 'half-way-up'"
check 'a LaTeX error is a failure' fails wrong_slides 's/|p + t v|/\\nosuchcommand/'
check 'and is shown' says 'nosuchcommand'
check 'by no picture that is left' test ! -e "build$scratch/answers/slides/wrong.pdf"
rm -rf "build$scratch"
without_slides() {
    make --no-print-directory slides SLIDES=none.txt
}
check 'SLIDES that is not there is an error' fails without_slides
check 'and is named' says 'SLIDES=none.txt: no such file'

# Questions to the class, made of known mistakes, are slides as well. An id that is not a mistake's is an error.
ask_the_class() {
    (unset MAKEFLAGS; make --no-print-directory questions && make --no-print-directory slides SLIDES="$BUILD/questions/questions.txt")
}
check 'the questions to the class are made' ask_the_class
every_answer_is_there() {
    pdftotext "$PROGRAMS/slides/questions.pdf" - | grep -c '^It was [A-D]: ' | grep -qx "$(grep -c '^[^# ]' chapters/mistakes/questions.txt)"
}
check 'each has its answer' every_answer_is_there

finish slides
