#!/bin/sh
# tree.sh - the tree as its users have it: a copy, the README's commands, answers in exercises/.
# In CI, where the README's commands have just built a clean clone, the copy has what they built.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once tree "the tree as its users have it"

tree=$scratch/tree
mkdir "$tree"
git ls-files -z --cached --others --exclude-standard | xargs -0 cp -p --parents -t "$tree" 2>/dev/null
[ -z "${CI:-}" ] || cp -a build "$tree"
cd "$tree" || exit 1

says() {
    make 2>&1 | grep -qF "$1"
}
make_quietly() {
    make --no-print-directory -j2 "$@" >"$scratch/log" 2>&1 || { tail -n 20 "$scratch/log"; return 1; }
}
only_rebuilds_nothing() {
    make --no-print-directory | grep -v 'Nothing to do' && return 1
    return 0
}
refused() {
    ! "$@" >"$scratch/log" 2>&1
}

check 'make builds and casts from a clean copy' make_quietly
check 'a second make does nothing and says so' only_rebuilds_nothing
check 'every picture is there' test -s build/solutions/gallery/three-spheres.png

check 'and a page of all' test -s build/solutions/gallery/index.html
if command -v gnuplot >/dev/null; then
    check 'with every figure, light and dark' test -s build/solutions/figures/corner-vectors/corner-vectors-dark.svg
    rm -r build/solutions/figures/corner-vectors build/solutions/drawn # this one is drawn again below
fi
check 'without gnuplot make goes on' without gnuplot make_quietly
check 'and says what to install' grep -qF "No figures: 'make setup' installs gnuplot" "$scratch/log"
check 'the scripts are written' test -s build/solutions/figures/corner-vectors/corner-vectors.gp
check 'make figures fails then' refused without gnuplot make figures
check 'and says what to install' grep -qF "gnuplot is missing, so no figure is drawn: 'make setup' installs it." "$scratch/log"
check 'without gnuplot a second make does nothing' without gnuplot only_rebuilds_nothing
if command -v gnuplot >/dev/null; then
    check 'once it is there, make goes on' make_quietly
    check 'and draws' test -s build/solutions/figures/corner-vectors/corner-vectors-dark.svg
fi

check 'without clang nothing is compiled for a page' refused without clang make build/wasm/common/camera.o
check 'and what to install is said' grep -qF "'make setup FOR=book' installs them" "$scratch/log"
if [ -z "${CI:-}" ]; then # .ci/run does that itself
    for file in exercises/*.c; do
        printf 'this is not C {{{\n' >"$file"
    done
    check 'make check passes with any contents of exercises/' make_quietly check
fi
for file in exercises/*.c; do
    cp "solutions/$(basename "$file")" "$file"
done
check 'with solutions in exercises/, make exercises is content' make_quietly exercises
check 'make ANSWERS=exercises draws with them' make_quietly ANSWERS=exercises
check 'and they draw the same picture' same_picture \
    build/solutions/gallery/sunflower.png build/exercises/gallery/sunflower.png

rm exercises/05-quadratic.c exercises/07-shading.c
check 'a picture that lacks answers is not an error' make_quietly ANSWERS=exercises
check 'one line says that it is not there yet' \
    grep -q 'not yet .*/sunflower.png: needs hit_sphere (and 3 more)' "$scratch/log"
check 'also for the pictures with light' grep -q 'not yet .*/07-diffuse.png: needs surface_normal' "$scratch/log"
three=chapters/06-ray-casting/three-spheres.nff
check 'a program that is run is refused' refused build/exercises/06-ray-casting -o "$scratch/x.png" $three
check 'and names every missing answer' grep -q 'not answered yet: quadratic_roots' "$scratch/log"
check 'so is light' refused build/exercises/07-shading -o "$scratch/x.png" $three
check 'with its names' grep -q 'not answered yet: offset_from_surface' "$scratch/log"
check 'the older picture is left as it was' same_picture \
    build/solutions/gallery/sunflower.png build/exercises/gallery/sunflower.png

cd "$here" || exit 1
finish tree
