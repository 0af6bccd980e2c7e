#!/bin/sh
# shading.sh - the picture in README.md is what the command beside it draws; and POV-Ray draws the same pictures of what
# is exported to it.
#
# In the tree the picture has a palette of 256 colors, dithered, which is a third of the bytes: colors are compared by the
# means of each 8 x 8 pixels, and by the mean of all differences. Of POV-Ray, flat: the same in every pixel but 5, on
# silhouettes, where rounding decides. Shaded: but for FEW pixels (silhouettes again, of shadows and mirrors) within a
# byte, and within MEAN on average.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once 'shading, long' "shaded pictures that take long"

picture=chapters/07-shading/finale.png
check 'the last picture is drawn' "$PROGRAMS/08-fast" --shaded --samples 2 --threads 2 -o "$scratch/finale.png" "$BUILD/scenes/finale.nff"
check 'its blocks of pixels are those of the tree' same_picture "$scratch/finale.png" $picture --blocks 16
check 'and all of it' same_picture "$scratch/finale.png" $picture 921600 7
check "it has less than 600 kB" test "$(wc -c <$picture)" -lt 600000
check 'README.md shows it' grep -qF "]($picture)" README.md
# One marble less is noticed: sphere 1200, which is not hidden.
fails() {
    ! "$@"
}
awk '!/^s/ || ++spheres != 1200' "$BUILD/scenes/finale.nff" >"$scratch/less.nff"
check 'with one marble less' "$PROGRAMS/08-fast" --shaded --samples 2 --threads 2 -o "$scratch/less.png" "$scratch/less.nff"
check 'it is another picture' fails same_picture "$scratch/less.png" $picture --blocks 16

# ---- POV-Ray --------------------------------------------------------------------------------------

few=30
mean=0.01
if ! command -v povray >/dev/null; then
    skip 'shading, long' 'the comparison with POV-Ray, which is not installed (make setup FOR=contributor)'
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
finish 'shading, long'
