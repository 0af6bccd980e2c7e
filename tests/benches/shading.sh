#!/bin/sh
# shading.sh - shadows and mirrors: how much sooner chapter 08's hierarchy draws chapter 07's picture.
#
# Whole processes, from the scene's file to the picture's; they take turns (turns.c). Then the pictures are
# compared. Usage: shading.sh SCENE.nff; in the environment PROGRAMS and TURNS from the Makefile, ROUNDS (5),
# SIZE (160x120), DEPTH (3).
set -u
scene=$1
size=${SIZE:-160x120}
depth=${DEPTH:-3}
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT

set -- "$PROGRAMS/07-shading" --depth "$depth" -s "$size" -o "$scratch/plain.png" "$scene" \
    -- 08-fast "$PROGRAMS/08-fast" --shaded -t % --depth "$depth" -s "$size" -o "$scratch/fast.png" "$scene"
echo "$(basename "$scene" .nff), shaded, $size, $depth mirrors deep, scene to picture: ${ROUNDS:-5} rounds in turns"
"$TURNS" "${ROUNDS:-5}" -- 07-shading "$@" && cmp "$scratch/plain.png" "$scratch/fast.png" && echo 'the same bytes'
