#!/bin/sh
# lessons.sh - what the lessons say of the programs is what the programs say, and the pictures and figures in them are
# what the code draws. (The SVGs of gnuplot 5.4 and 6.0 are the same bytes.)
#
# DRAWN: a folder that has the figures; without it they are drawn here. MOST_BYTES: of a picture.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh

# The lines of the ```text blocks of a lesson and the pages beside it, all of which the chapter's program must print.
quotes_its_program() {
    "$PROGRAMS/$1" >"$scratch/printed" || return 1
    awk '/^```text$/ { inside = 1; next } /^```/ { inside = 0 } inside && NF' \
        "chapters/$1/"*.md >"$scratch/quoted"
    [ -s "$scratch/quoted" ] || { echo "no \`\`\`text block"; return 1; }
    ! grep -vxFf "$scratch/printed" "$scratch/quoted"
}

for lesson in chapters/[0-9]*/README.md; do
    stem=$(basename "$(dirname "$lesson")")
    check "the lesson of $stem quotes its program" quotes_its_program "$stem"
    check "the links of $lesson lead somewhere" links_lead_somewhere "$lesson"
    check "the verdicts and hints of $stem have the letters of its lesson" python3 -B tests/house/letters.py "$stem"
done
sed -n 's/^= //p' chapters/lessons/lines.txt >"$scratch/stems"
while IFS= read -r stem; do
    check "the lesson of $stem is what 'make lessons' writes" \
        diff "$BUILD/lessons/$stem.md" "chapters/$stem/README.md"
done <"$scratch/stems"
# What no lesson and no slide says need not be computed.
names_in_use() {
    "$BUILD/chapters/lessons/numbers" | grep -o '"[A-Za-z0-9_]*": ' | tr -d '": ' >"$scratch/names"
    [ -s "$scratch/names" ] && while IFS= read -r name; do
        grep -qF "[[$name]]" chapters/lessons/lines.txt chapters/slides.txt || { echo "not used: $name" && return 1; }
    done <"$scratch/names"
}
check 'each number of the example is in a lesson or on a slide' names_in_use
for page in README.md chapters/README.md chapters/08-fast/engines.md chapters/book/README.md exercises/README.md tests/grade/README.md \
    tests/grade/recipes/README.md .github/CONTRIBUTING.md; do
    check "the links of $page lead somewhere" links_lead_somewhere "$page"
done

# Each picture that is drawn while a chapter is answered has its name in the lesson of that chapter.
names_its_pictures() {
    sed -n 's/^PICTURE("\([^"]*\)".*/\1/p' tests/course/pictures/pictures.def >"$scratch/pictures"
    [ -s "$scratch/pictures" ] && while IFS= read -r name; do
        grep -qF "$name.png" chapters/"${name%%-*}"-*/README.md || { echo "not there: $name.png" && return 1; }
    done <"$scratch/pictures"
}
check 'the lessons name the pictures that are drawn on the way' names_its_pictures

# The files that the page on 08's engines tells its reader to read.
files_are_there() {
    # shellcheck disable=SC2016 # these are Markdown's backquotes
    [ "$(grep -o '`[a-z_]*\.[ch]`' chapters/08-fast/engines.md | tr -d '`' | sort -u | tee "$scratch/files" | wc -l)" -gt 20 ] &&
        while IFS= read -r file; do
            [ -e "chapters/08-fast/engines/$file" ] || [ -e "chapters/08-fast/$file" ] || [ -e "common/$file" ] ||
                { echo "not there: $file" && return 1; }
        done <"$scratch/files"
}
check "the page on 08's engines names files that exist" files_are_there

# make names the folder whose path has a blank, and nothing else.
refuses_the_blank_in() {
    make "$@" help >"$scratch/printed" 2>&1 && return 1
    cat "$scratch/printed"
    grep -qF "$wanted" "$scratch/printed" && ! grep -q solutions "$scratch/printed"
}
mkdir -p "$scratch/a blank" && ln -s "$PWD/Makefile" "$scratch/a blank/Makefile"
wanted="a blank'"
check 'a space in the path of the toolkit is reported' refuses_the_blank_in -C "$scratch/a blank"
wanted="ANSWERS='a blank': expected one folder"
check 'a space in the path of the answers is reported' refuses_the_blank_in ANSWERS='a blank'

# ---- pictures and figures ------------------------------------------------------------------------

once lessons "the pictures and figures in the lessons"
# The pow of another machine may round light differently.
allowed_in() {
    case $1 in 0?-spheres.png | 07-*.png | still-something-missing.png) echo 100 ;; *) echo 0 ;; esac
}
for chapter in chapters/[0-9]*; do
    check "the lesson of ${chapter#chapters/} shows a picture that the student's code draws" \
        grep -qE '^!\[[^]]+\]\(([a-z0-9/.-]+)\.png\)$' "$chapter/README.md"
done
for picture in chapters/[0-9]*/*.png; do
    name=${picture##*/}
    check "a lesson shows $picture" grep -qE "[(/]$name\)" chapters/[0-9]*/README.md
    # These two take too long to be drawn here: shading.txt and proof/shading.sh draw them.
    case $name in sphereflake.png | finale.png) continue ;; esac
    check "$picture is small" test "$(wc -c <"$picture")" -le "${MOST_BYTES:-100000}"
    drawn=$BUILD/so-far/$name
    [ -e "$drawn" ] || drawn=$PROGRAMS/gallery/$name
    check "$picture is what the programs draw" same_picture "$drawn" "$picture" "$(allowed_in "$name")"
done
needs lessons "that the lessons' figures are those of the code" gnuplot
draw() {
    DRAWN=$scratch/drawn
    scripts_into "$DRAWN" || return 1
    # shellcheck disable=SC2046,SC2086 # names are words
    FORMAT=svg THEME='' SHAPE='' STEPS='' python3 chapters/gallery/draw_figures.py "$DRAWN" $names &&
        FORMAT=svg THEME='' SHAPE='' STEPS=1 python3 chapters/gallery/draw_figures.py "$DRAWN" \
            $(python3 -B chapters/lessons/lesson_figures.py --in-steps chapters/[0-9]*)
}
[ -n "${DRAWN:-}" ] || check 'the figures are drawn' draw
for chapter in chapters/[0-9]*; do
    check "${chapter#chapters/} shows its figures as the code draws them" \
        python3 -B chapters/lessons/lesson_figures.py "$DRAWN" "$chapter"
done
finish lessons
