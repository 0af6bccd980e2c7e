#!/bin/sh
# gallery_page.sh - the page of pictures follows the lecture, and describes everything on it.
#
# Its pictures are small here, and need neither gnuplot nor a browser (tests/proof/gallery.sh has both).
# Only reads the tree.
set -u
. tests/house/runner/library.sh
once gallery_page "the page of pictures, its order and words"

built=$scratch/solutions
page=$built/gallery/index.html
mkdir -p "$built/gallery"
"$PROGRAMS/03-screen" --picture "$scratch/small.png" || exit 1
figure() {
    mkdir -p "$built/figures/$1"
    printf '<svg viewBox="0 0 960 540"></svg>\n' >"$built/figures/$1/$1.svg"
    printf 'The title of %s\n\nWhat there is to see in the figure %s, in some words.\n' "$1" "$1" >"$built/figures/$1/$1.txt"
}
pictures=$(make -s --no-print-directory list-pictures)
for picture in $pictures; do
    cp "$scratch/small.png" "$built/gallery/$picture.png"
done
for layout in chapters/*/figures/*.gp; do
    figure "$(basename "$layout" .gp)"
done
makes() {
    "$BUILD/chapters/gallery/gallery" "$built" "$BUILD/scenes"
}
says() {
    grep -qF -- "$1" "$page"
}
says_not() {
    ! says "$1"
}
check 'there are pictures' test "$(echo "$pictures" | wc -w)" -gt 10
check 'the page is made' makes

# The deck's order; then chapters 07 and 08.
headings() {
    sed -n 's/.*<h2 id="[^"]*">\(.*\)<\/h2>/\1/p' "$page" >"$scratch/headings"
    cat >"$scratch/expected" <<'END'
Two ways of rendering (chapter 06)
Ray casting (chapter 06)
Camera (chapter 01)
Finding vectors from the eye to the image plane (chapter 01)
Other camera representations (chapter 02)
Normalized screen coordinates (chapter 03)
Mapping from pixel to camera ray (chapter 04)
The ray casting process (chapter 06)
Ray and sphere (chapter 05)
Ray and sphere in world coordinates (chapter 05)
Still something missing ... (chapter 07)
Light (chapter 07)
The same picture, faster (chapter 08)
END
    diff "$scratch/expected" "$scratch/headings"
}
check 'its sections are those of the lecture, and everything that make draws is in one of them' headings
section_of() {
    awk -v wanted="$1" '/<h2 / { heading = $0 } index($0, wanted) { print heading; exit }' "$page" | grep -F "$2"
}
check 'object order is in the first' section_of 'src="../figures/object-order/' 'Two ways of rendering'
check 'the parts of light are in chapter 07' section_of 'src="07-ambient.png"' 'Light (chapter 07)'
check 'chapter 08 has pictures' section_of 'src="finale.png"' '(chapter 08)'
every_one_once() {
    for picture in $pictures; do
        [ "$(grep -c "<img src=\"$picture.png\"" "$page")" -eq 1 ] || { echo "$picture"; return 1; }
    done
    for layout in chapters/*/figures/*.gp; do
        name=$(basename "$layout" .gp)
        [ "$(grep -c "<img src=\"../figures/$name/$name.svg\"" "$page")" -eq 1 ] || { echo "$name"; return 1; }
    done
}
check 'each picture and each figure is there once' every_one_once
described() {
    grep -o ' alt="[^"]*"' "$page" | awk 'length($0) < 60 { print; bad = 1 } END { exit bad || NR < 20 }' &&
        says_not 'drawn from a scene'
}
check 'each is described in words' described
check 'a narrow screen has no narrow figure before it is drawn' says_not '-4x3'
cp "$built/figures/parabola/parabola.svg" "$built/figures/parabola/parabola-4x3.svg"
check 'the page is made again' makes
check 'and then it has' says '<source media="(max-width: 600px)" srcset="../figures/parabola/parabola-4x3.svg"'

# What is not in the list comes after it.
figure my-own
cp "$scratch/small.png" "$built/gallery/mine.png"
for name in closest-hit other; do
    mkdir -p "$built/animations/$name/frames" "$built/animations/closest-hit/frames-dark"
    cp "$scratch/small.png" "$built/animations/$name/frames/0001.png"
    : >"$built/animations/$name/$name.mp4"
    printf 'It moves: %s\n\nThe ray moves.\n' "$name" >"$built/animations/$name/$name.txt"
done
cp "$scratch/small.png" "$built/animations/closest-hit/frames-dark/0001.png"
: >"$built/animations/closest-hit/closest-hit-dark.webm"
check 'the page is made with more' makes
check "a figure of one's own is at the end" section_of '../figures/my-own/my-own.svg' 'Your own figures'
check 'so is a picture of another scene' section_of 'src="mine.png"' 'More pictures'
check 'an animation is where the lecture has it' section_of '../animations/closest-hit/closest-hit.mp4' 'Ray casting (chapter 06)'
check 'with its dark one' says '<video class="in-dark" controls loop muted playsinline preload="none"'
check 'from its file' says '<source src="../animations/closest-hit/closest-hit-dark.webm" type="video/webm">'
check 'which begins only if it is asked to' says_not 'autoplay'
check 'another animation is at the end' section_of '../animations/other/other.mp4' 'More animations'
finish gallery_page
