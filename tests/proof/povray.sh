#!/bin/sh
# povray.sh - POV-Ray draws the same pictures of what is exported to it.
#
# Flat: the same in every pixel but FEW, on silhouettes, where rounding decides. Shaded: but for FEW
# pixels (silhouettes again, of shadows and mirrors) within a byte, and within MEAN on average.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once povray "the comparison with POV-Ray"

few=30
mean=0.01
if ! command -v povray >/dev/null; then
    skip povray 'the comparison with POV-Ray, which is not installed (make setup FOR=contributor)'
fi
agrees() {
    name=$1
    scene=$2
    shift 2
    "$PROGRAMS/07-shading" "$@" -s 320x240 -o "$scratch/ours.png" "$scene" &&
        "$PROGRAMS/07-shading" "$@" -s 320x240 --export pov -o "$scratch/$name.pov" "$scene" &&
        (cd "$scratch" && povray "+I$name.pov" +Otheirs.png +W320 +H240 -A -D >log 2>&1) || return 1
    case $1 in
    --flat) same_picture "$scratch/ours.png" "$scratch/theirs.png" 5 ;;
    *) same_picture "$scratch/ours.png" "$scratch/theirs.png" $few $mean ;;
    esac
}
for scene in chapters/06-ray-casting/three-spheres.nff "$BUILD/scenes/sunflower.nff" \
    "$BUILD/scenes/sphereflake-91.nff"; do
    name=$(basename "$scene" .nff)
    check "$name: flat, the same picture" agrees "$name" "$scene" --flat
    check "$name: shaded, the same but for rounding" agrees "$name" "$scene" --depth 5
done
check 'also with a distant light' agrees three-spheres chapters/06-ray-casting/three-spheres.nff --sun 1,2,3
# Not by luck: the mirror image is another picture.
mirrored_is_another() {
    sed 's/right <15/right <-15/' "$scratch/three-spheres.pov" >"$scratch/mirrored.pov"
    (cd "$scratch" && povray +Imirrored.pov +Omirrored.png +W320 +H240 -A -D >log 2>&1) &&
        ! same_picture "$scratch/ours.png" "$scratch/mirrored.png" $few $mean
}
check 'the mirror image is not taken for it' mirrored_is_another
finish povray
