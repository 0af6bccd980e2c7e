#!/bin/sh
# pictures.sh - what libpng's settings cost and save, on flat and shaded pictures of 1920 x 1080.
#
# Usage: pictures.sh BUILD-FOLDER PROGRAMS-FOLDER
set -u
build=$1
programs=$2
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
three=chapters/06-ray-casting/three-spheres.nff
for scene in $three "$build/scenes/sphereflake-7381.nff" "$build/scenes/sphereflake-597871.nff" \
    "$build/scenes/sunflower.nff"; do
    "$programs/08-fast" -s 1920x1080 -e object -o "$scratch/flat-$(basename "$scene" .nff).png" "$scene" 2>/dev/null
done
for scene in $three "$build/scenes/sphereflake-91.nff" "$build/scenes/sunflower.nff"; do
    "$programs/07-shading" -s 1920x1080 -o "$scratch/shaded-$(basename "$scene" .nff).png" "$scene" 2>/dev/null
done
cd "$scratch" && "$OLDPWD/$build/tests/benches/pictures" ./*.png
