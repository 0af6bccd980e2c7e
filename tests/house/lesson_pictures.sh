#!/bin/sh
# lesson_pictures.sh - the pictures in the lessons are pixel for pixel those that the programs draw.
# Only reads the tree.
set -u
. tests/house/runner/library.sh
once 'pictures in the lessons' "the pictures in the lessons"

# The pow of another machine may round light differently.
allowed_in() {
    case $1 in 0?-spheres.png | 07-*.png | still-something-missing.png) echo 100 ;; *) echo 0 ;; esac
}
most_bytes=${MOST_BYTES:-100000}
for chapter in chapters/[0-9]*; do
    stem=${chapter#chapters/}
    check "the lesson of $stem shows a picture that the student's code draws" \
        grep -qE '^!\[[^]]+\]\(([a-z0-9/.-]+)\.png\)$' "$chapter/README.md"
done
for picture in chapters/[0-9]*/*.png; do
    name=${picture##*/}
    check "a lesson shows $picture" grep -qE "[(/]$name\)" chapters/[0-9]*/README.md
    # These two take too long to be drawn here: fast_program.sh and finale.sh draw them.
    case $name in sphereflake.png | finale.png) continue ;; esac
    check "$picture has at most $most_bytes bytes" test "$(wc -c <"$picture")" -le "$most_bytes"
    drawn=$BUILD/so-far/$name
    [ -e "$drawn" ] || drawn=$PROGRAMS/gallery/$name
    check "$picture is what the programs draw" same_picture "$drawn" "$picture" "$(allowed_in "$name")"
done
# A chapter's own picture has the title that it has on the page of all pictures.
for picture in chapters/[0-9]*/[0-9][0-9]-*.png; do
    stem=$(basename "$picture" .png)
    title=$(sed -n "/^picture $stem\$/ { n; s/^ *//p; }" chapters/gallery/contents.txt)
    [ ! -d "chapters/$stem" ] || check "the picture of $stem is called by its title" \
        grep -qxF "![$title]($stem.png)" "chapters/$stem/README.md"
done
finish 'pictures in the lessons'
