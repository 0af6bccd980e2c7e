#!/bin/sh
# slides.sh - the Beamer slides, and every figure and step as LaTeX takes it in.
set -u
. tests/house/runner/library.sh
. tests/house/figures/scripts.sh
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

drawn=$scratch/figures
check 'every figure has a script' scripts_into "$drawn"
draw() {
    # shellcheck disable=SC2086 # names are words
    env "$@" "$BUILD/chapters/gallery/draw_figures" "$drawn" $names
}
check 'every figure is drawn for LaTeX' draw FORMAT=tex SHAPE=16:9,4:3 STEPS=1
steps=$(cat "$drawn/.drawn/corner-vectors.steps")
check 'the slides are made' chapters/make_slides "$drawn" chapters/slides.tex
pages() {
    pdfinfo "$1" | sed -n 's/^Pages: *//p'
}
if command -v pdfinfo >/dev/null; then
    check 'with a page for each step, and one for the whole' test "$(pages "$drawn/slides.pdf")" -eq $((steps + 1))
    check 'also with dark pages' test "$(pages "$drawn/slides-dark.pdf")" -eq $((steps + 1))
    has_text() {
        pdftotext "$drawn/slides.pdf" - | grep -q '(−1, 1, 4)\|(-1, 1, 4)'
    }
    check 'with the labels as text' has_text
else
    echo "skipped: the pages of slides, which need poppler-utils ('make setup' installs it)"
fi
cp "$drawn/slides.pdf" "$scratch/first.pdf"
check 'slides are made once more' chapters/make_slides "$drawn" chapters/slides.tex
check 'and have the same bytes' cmp "$drawn/slides.pdf" "$scratch/first.pdf"

# A folder of its own, with all that 'make figures FORMAT=tex' made: every file on a page.
talk=$scratch/talk
mkdir "$talk"
cp "$drawn"/*/*.tex "$drawn"/*/*-tex.pdf "$talk"
sed '/^\\begin{document}/,$d' chapters/slides.tex >"$talk/talk.tex"
{
    printf '%s\n' '\begin{document}'
    for file in "$drawn"/*/*.tex; do
        printf '\\begin{frame}[plain]\\centering\\resizebox{!}{\\textheight}{\\input{%s}}\\end{frame}\n' "${file##*/}"
    done
    printf '%s\n' '\end{document}'
} >>"$talk/talk.tex"
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
cp chapters/slides.tex "$talk/"
check 'the slides are made there by LaTeX alone' compiles slides
check 'and in the dark' compiles '\def\theme{dark}\input{slides}'

printf '\\documentclass{beamer}\n\\begin{document}\n\\nosuchcommand\n\\end{document}\n' >"$scratch/wrong.tex"
check 'a LaTeX error is a failure' fails chapters/make_slides "$drawn" "$scratch/wrong.tex"
check 'and is shown' says 'nosuchcommand'
check 'by no picture that is left' test ! -e "$drawn/wrong.pdf"

finish slides
