#!/bin/sh
# gallery.sh - the page of pictures and figures, in a headless Chromium.
# Only reads the tree.
set -u
. tests/house/runner/library.sh
. tests/house/figures/scripts.sh
once gallery "the page of pictures"

needs gallery 'the page of pictures' gnuplot python3
built=$scratch/solutions
page=$built/gallery/index.html
mkdir -p "$built/gallery"
scripts_into "$built/figures" || exit 1
for chapter in chapters/0[1-5]-*; do
    stem=${chapter#chapters/}
    "$PROGRAMS/$stem" --picture "$built/gallery/$stem.png" || exit 1
done
for scene in chapters/06-ray-casting/*.nff "$BUILD"/scenes/*.nff; do
    # Chapter 06's own loop takes minutes for the scenes that are there to be measured.
    "$PROGRAMS/08-fast" -s 160x120 -o "$built/gallery/$(basename "$scene" .nff).png" "$scene" 2>"$scratch/said" || exit 1
done
# A picture whose name is not fit for a page.
cp "$built/gallery/sunflower.png" "$built/gallery/a \"<b>\" & c#1 50%?.png"

# A few are enough for what the page links; a browser looks at all.
draw() {
    # shellcheck disable=SC2086 # names are words
    env "$@" python3 chapters/gallery/draw_figures.py "$built/figures" ${drawn:-$first}
}
says() {
    grep -qF -- "$1" "$page"
}
says_not() {
    ! says "$1"
}
check 'a page is made without any figure' python3 chapters/gallery/gallery.py "$built" "$BUILD/scenes"
check 'and says so' says 'No figure is drawn yet'
first=$(echo "$names" | cut -d' ' -f2)
check 'a figure is drawn' draw FORMAT=svg,png SHAPE=16:9,4:3 STEPS=1
check 'the page is made' python3 chapters/gallery/gallery.py "$built" "$BUILD/scenes"
check 'it links what is there' says "../figures/$first/$first-dark.png"
check 'each step' says "../figures/$first/$first-4x3-step1-dark.svg"
check 'and not what is not' says_not "../figures/$first/$first.pdf"
cp "$page" "$scratch/before.html"
check 'the page has the same bytes' python3 chapters/gallery/gallery.py "$built" "$BUILD/scenes"
check 'every time' cmp "$page" "$scratch/before.html"
# Animations are on the page if they are there.
check 'without animations there are no videos' says_not '<video'
mkdir -p "$built/animations/image-order/frames"
cp "$built/gallery/01-corners.png" "$built/animations/image-order/frames/0001.png"
printf 'A title & more\nIts words.\n' >"$built/animations/image-order/image-order.txt"
touch "$built/animations/image-order/image-order.mp4"
check 'a page is made beside an animation' python3 chapters/gallery/gallery.py "$built" "$BUILD/scenes"
check 'the page shows its video' says '<source src="../animations/image-order/image-order.mp4" type="video/mp4">'
check 'with its last frame before it moves' says 'poster="../animations/image-order/frames/0001.png" aria-label="Its words."'
check 'and its title' says '<h3>A title &amp; more</h3>'
check 'and not what is not there' says_not 'image-order.webm'
rm -r "$built/animations"
# The figure of an older script is not linked.
echo '# another' >>"$built/figures/$first/$first.gp"
check 'with another script' draw FORMAT=svg THEME=light,dark
check 'the page is made once more' python3 chapters/gallery/gallery.py "$built" "$BUILD/scenes"
check 'and does not link what was drawn before' says_not "../figures/$first/$first.png"
check 'but what is drawn now' says "../figures/$first/$first-dark.svg"
# On a narrow screen a figure has its narrow shape.
check 'the figure is drawn again, in all formats' draw FORMAT=svg,png,pdf,tex
drawn=$names
check 'all are drawn in both shapes, with their steps' draw FORMAT=svg SHAPE=16:9,4:3 STEPS=1
check 'for the browser' python3 chapters/gallery/gallery.py "$built" "$BUILD/scenes"

if ! python3 -c 'import sys; sys.path.insert(0, "tests/house/figures"); import browser; sys.exit(not browser.found())'; then
    skip gallery "the page in a browser, which needs Chromium (make setup FOR=contributor)"
fi
# shellcheck disable=SC2086
counted python3 tests/house/figures/gallery.py "$page" "$(echo $names | wc -w)"
finish gallery
