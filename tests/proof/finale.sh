#!/bin/sh
# finale.sh - the picture in README.md is what the command beside it draws.
#
# In the tree it has a palette of 256 colors, dithered, which is a third of the bytes: colors are compared
# by the means of each 8 x 8 pixels, and by the mean of all differences.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once finale "the picture in README.md"

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
finish finale
