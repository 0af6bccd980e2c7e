#!/bin/sh
# engines.sh - chapter 08's engines on all scenes there are, on 3,000 random ones and as many whose numbers are far apart,
# flat and with light, and on processors that have less. ENGINE_SCENES and ENGINE_SIZE (1920x1080) in the environment
# make it fewer and smaller.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh

same=$BUILD/tests/house/engines/same_pictures
scenes=$BUILD/scenes
three=chapters/06-ray-casting/three-spheres.nff

# ---- the same picture ---------------------------------------------------------------------------

# Against chapter 06's loop; of what takes it more than 1e10 tests of a ray and a sphere, against the
# hierarchy.
if [ -z "${BRIEF:-}" ]; then
    counted "$same" "${ENGINE_SCENES:-3000}" 101
    # shellcheck disable=SC2046 # names are words
    counted "$same" "${ENGINE_SIZE:-1920x1080}" 1e10 $(echo chapters/06-ray-casting/*.nff chapters/*/figures/*.nff) \
        "$scenes"/*.nff
    [ -n "${ENGINE_SIZE:-}" ] || counted "$same" 4096x4096 1e10 "$three" "$scenes/sphereflake-91.nff"
else
    echo "skipped: engines on the largest scenes, which are tested once (BRIEF)"
    counted "$same" 100 101
    counted "$same" 320x180 1e10 "$three" "$scenes/sphereflake-91.nff"
fi

# ---- instruction sets ---------------------------------------------------------------------------

# A processor without AVX, and one with AVX2; an instruction that it lacks ends the program.
case "$(uname -m) $BUILD" in
*sanitize*) echo "skipped: engines on other processors, where sanitizers do not run" ;;
x86_64*)
    if command -v qemu-x86_64 >/dev/null; then
        counted qemu-x86_64 -cpu Nehalem "$same" 15 101
        counted qemu-x86_64 -cpu max "$same" 5 101
    else
        echo "skipped: engines on other processors, which need QEMU (make setup FOR=contributor)"
    fi
    ;;
esac

# ---- the bench ----------------------------------------------------------------------------------

names_what_is_missing() {
    mkdir "$scratch/bench"
    PATH=/nowhere "$BUILD/tests/benches/flat" -p -e povray -e plain -r 1 -s 8x6 -o "$scratch/bench" "$three" >"$scratch/said" 2>&1 &&
        says 'povray is not installed, so it is not measured' && says '  plain  '
}
[ -n "${BRIEF:-}" ] || check 'the bench names a peer that is not installed, and goes on' names_what_is_missing

finish 'engines, long'
