#!/bin/sh
# any_folder.sh - programs find their layouts and scenes from any folder, by any way of starting them.
# Only reads the tree.
set -u
. tests/house/runner/library.sh
built=$(cd "$PROGRAMS" && pwd)
with_programs=PATH=$built:$PATH
. tests/house/figures/scripts.sh
once any_folder "programs in any folder"

check 'every figure has a script' scripts_into "$scratch/here"
mkdir "$scratch/nowhere" "$scratch/links"
ln -s "$built"/0* "$scratch/links/"

# The same bytes in another folder: by the program's whole path, by a link to it, and by its name alone.
same_scripts() {
    way=$1
    for layout in chapters/*/figures/*.gp; do
        name=$(basename "$layout" .gp)
        stem=$(basename "${layout%/figures/*}")
        (cd "$scratch/nowhere" && env "$with_programs" "$way$stem" --figure "$name") >"$scratch/there.gp" &&
            cmp "$scratch/there.gp" "$scratch/here/$name/$name.gp" || return 1
    done
}
check 'a program prints its figures in any folder' same_scripts "$built/"
check 'also if a link leads to it' same_scripts "$scratch/links/"
check 'and if it is found by PATH' same_scripts ''

# Without a scene, a program draws its own.
draws_its_scene() {
    (cd "$scratch/nowhere" && env "$with_programs" "$1" -s 32x24 -o "$scratch/$2.png") &&
        "$PROGRAMS/06-ray-casting" -s 32x24 -o "$scratch/own.png" && cmp "$scratch/$2.png" "$scratch/own.png"
}
check 'its scene is found from any folder' draws_its_scene "$built/06-ray-casting" whole
check 'also if a link leads to the program' draws_its_scene "$scratch/links/06-ray-casting" link
check 'and if it is found by PATH' draws_its_scene 06-ray-casting path

# A program reads the layouts of its own tree, wherever it is started: here from the top of another tree.
tree=$scratch/tree
mkdir -p "$tree/build/solutions" "$tree/chapters"
cp -r common "$tree"
cp -r chapters/05-quadratic "$tree/chapters"
cp "$PROGRAMS/05-quadratic" "$tree/build/solutions"
echo '# edited' >>"$tree/chapters/05-quadratic/figures/parabola.gp"
takes_the_edit() {
    "$tree/build/solutions/05-quadratic" --figure parabola >"$scratch/said" && grep -q '^# edited$' "$scratch/said"
}
check 'an edited layout is read, without building anything' takes_the_edit

# A program that is in no tree.
cp "$PROGRAMS/05-quadratic" "$scratch/alone"
prints() {
    (cd "$1" && "$scratch/alone" --figure parabola) >"$scratch/parabola.gp" 2>"$scratch/said"
}
check 'a copy elsewhere uses the tree of the current folder' prints "$tree/common/figure"
refused() {
    ! prints "$scratch/nowhere" && [ ! -s "$scratch/parabola.gp" ]
}
check 'and fails outside any tree' refused
check 'with the name of the missing file, and where it was looked for' says \
    'alone: common/figure/plot.gp is neither above this program nor above the current folder'

# A layout that cannot be read is named, and nothing is printed.
lays_out() {
    ! "$PROGRAMS/05-quadratic" --figure parabola --layout "$1" >"$scratch/parabola.gp" 2>"$scratch/said" &&
        [ ! -s "$scratch/parabola.gp" ] && says "$2"
}
check 'a layout that does not exist is refused' lays_out "$scratch/none.gp" "$scratch/none.gp: cannot be read: No such file"
check 'so is a folder' lays_out "$scratch" "$scratch: cannot be read: Is a directory"
finish any_folder
