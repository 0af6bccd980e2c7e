#!/bin/sh
# wait.sh - what the user waits for: from the scene's file to the picture's, whole processes.
#
# Chapter 08's program beside reading and writing alone (alone.c); with PEERS=1 also POV-Ray, Tachyon and an
# Embree program. The pictures are compared first; the scene is given to POV-Ray and to Tachyon in their own
# languages. Usage: wait.sh SCENE.nff; in the environment PROGRAMS and BUILD from the Makefile, ROUNDS (7).
set -u
scene=$1
width=1920
height=1080
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
ours="$PROGRAMS/08-fast"

set -- -- alone "$BUILD/tests/benches/alone" "$scene" "$scratch/alone.png" $width $height % \
    -- ours "$ours" -t % -s ${width}x$height -o "$scratch/ours.png" "$scene"
if [ -n "${PEERS:-}" ]; then
    for name in povray tachyon; do
        command -v $name >/dev/null || { echo "$name is not installed: make setup FOR=bench"; continue; }
        # One picture writes the scene in its language, and is compared.
        BENCH_SCRATCH=$scratch "$BUILD/tests/benches/engines-and-peers" -r 1 -l 600 -e $name \
            -s ${width}x$height "$scene" >"$scratch/said" 2>&1
        if ! grep -q "^  $name" "$scratch/said"; then
            cat "$scratch/said"
        elif [ $name = povray ]; then
            set -- "$@" -- povray povray "+I$scratch/peer.pov" "+O$scratch/povray.png" +W$width +H$height +WT% -A -D
        else # A row and a column more: peers/programs.c says why.
            set -- "$@" -- tachyon tachyon "$scratch/peer.dat" -lowestshade -numthreads % -format PNG \
                -o "$scratch/tachyon.png"
        fi
    done
    embree="$BUILD/tests/benches/peers/embree_wait"
    if [ ! -x "$embree" ]; then
        echo 'Embree 3 is not installed: make setup FOR=bench'
    elif "$ours" -s ${width}x$height -o "$scratch/ours.png" "$scene" 2>/dev/null &&
        "$embree" "$scene" "$scratch/embree.png" $width $height 1 &&
        "$BUILD/tests/same_picture" "$scratch/ours.png" "$scratch/embree.png" 1000; then
        set -- "$@" -- embree "$embree" "$scene" "$scratch/embree.png" $width $height %
    fi
fi
echo "$scene to picture, ${width}x$height, ${ROUNDS:-7} rounds in turns"
"$BUILD/tests/benches/turns" "${ROUNDS:-7}" "$@"
