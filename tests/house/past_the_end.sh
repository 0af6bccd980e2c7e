#!/bin/sh
# past_the_end.sh - answers whose loops run once too often, past the end of what they are given.
#
# Memory there could hold anything, also what makes the result right by luck. The answering process
# puts guards there (tests/judge/wire.h).
# Builds only below its answers.
# shellcheck disable=SC2016 # sed ends its addresses with $
set -u
. tests/house/runner/library.sh
ordinary past_the_end "loops past the end"

answers=$scratch/answers
export NO_COLOR=1
mkdir "$answers"

# Judges a chapter with the solution's answers, but for what the sed command changes.
slip() {
    sed "$2" "solutions/$1.c" >"$answers/$1.c"
    ! cmp -s "solutions/$1.c" "$answers/$1.c" || return 1
    exercises "$answers" EX="${1%%-*}" >"$scratch/said" 2>&1
}
# The first answer that is not right is this one.
fails() {
    function=$1
    shift
    slip "$@"
    cat "$scratch/said"
    grep -q "^[0-9][-a-z0-9]*  $function\( \|$\)" "$scratch/said"
}

check 'a pixel too many among the spheres' fails cast_object_order 06-ray-casting \
    's|^        for (int i = 0; i < width|        for (int i = 0; i <= width|'
check 'a depth too many that is set' fails cast_object_order 06-ray-casting \
    's|depth\[i\] = NO_HIT;|depth[i + 1] = depth[i] = NO_HIT;|'
check 'is reported' says 'it         wrote past the end of the image or of depth'
check 'a depth before the first' fails cast_object_order 06-ray-casting \
    's|depth\[i\] = NO_HIT;|depth[i - 1] = depth[i] = NO_HIT;|'
check 'a pixel too many that is painted past image_set' fails cast_image_order 06-ray-casting \
    's|image_set(image, pixel,|image_bytes(image, pixel)[3] = 7, &|'
check 'is reported as well' says 'it         wrote past the end of the image or of depth'
check 'a sphere too many' fails nearest_hit 06-ray-casting 's|i < scene->sphere_count|i <= scene->sphere_count|'
check 'is named' says 'looks like a loop up to i <= sphere_count'
check 'a sphere too many in the shadow' fails visibility 07-shading \
    '/^double visibility/,/^}/s|i < scene->sphere_count|i <= scene->sphere_count|'
check 'a sphere before the first' fails visibility 07-shading '/^double visibility/,/^}/s|int i = 0|int i = -1|'
check 'a light too many' fails shade 07-shading 's!i < scene->light_count!i <= scene->light_count!'
check 'is named as well' says 'looks like a loop up to i <= light_count'
# A wrong result says more than a write in the wrong place.
check 'rows of another length' fails cast_object_order 06-ray-casting \
    '/sphere_count/,$s|depth\[i\]|depth[i / width * height + i % width]|'
check 'are named' says 'looks like depth[row * height + column]'
check 'what is right stays right' slip 06-ray-casting 's|width \* height|height * width|'
finish past_the_end
