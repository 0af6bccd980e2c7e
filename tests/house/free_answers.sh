#!/bin/sh
# free_answers.sh - answers that are right and use the freedom of their contracts make the same pictures and figures as
# the reference: a ray's direction of length 3, and the slides' formulas for roots, which round in another way. And chapter
# 08's shaded pictures are those of the answers, not of the formulas that its engines know.
# Builds only below its answers.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once free_answers "answers that use their freedom"

answers=$scratch/free
free=build$answers
right=build/solutions
trap 'end_started; rm -rf "$free" "$scratch"' EXIT

programs='01-corners 02-cameras 03-screen 04-pixel-ray 05-quadratic 06-ray-casting 07-shading 08-fast'
builds() {
    mkdir -p "$answers" && cp solutions/*.c "$answers" &&
        sed 's/, \(image_plane_vector(.*)\)}/, 3 * vec3_unit(\1)}/' solutions/04-pixel-ray.c >"$answers/04-pixel-ray.c" &&
        ! cmp -s solutions/04-pixel-ray.c "$answers/04-pixel-ray.c" || return 1
    by_reference=
    by_them=
    for stem in $programs; do
        by_reference="$by_reference $right/$stem"
        by_them="$by_them $free/$stem"
    done
    # shellcheck disable=SC2086 # several words
    { make -s ANSWERS=solutions $by_reference && make -s ANSWERS="$answers" $by_them; } >"$scratch/said" 2>&1 ||
        { tail -n 20 "$scratch/said"; return 1; }
}
check 'answers that use every freedom build' builds

judged_right() {
    make --no-print-directory exercises ANSWERS="$answers" EX="$1" >"$scratch/said" 2>&1
    says "$2 is right"
}
check 'a direction 3 long is judged right' judged_right 04 04-pixel-ray
check 'so are the formulas of the slides' judged_right 05 05-quadratic

same() {
    program=$1
    shift
    "$right/$program" "$@" "$scratch/right.png" >"$scratch/said" 2>&1 &&
        "$free/$program" "$@" "$scratch/free.png" >"$scratch/said" 2>&1 &&
        same_picture "$scratch/right.png" "$scratch/free.png"
}
check 'by them the sphere of 05 is the same picture' same 05-quadratic --picture
check 'the spheres of 06 are' same 06-ray-casting -s 160x120 -o
check 'and in object order' same 06-ray-casting -s 160x120 --order object -o
check 'the shaded spheres of 07 are' same 07-shading -s 80x60 -o
for engine in plain object bvh packet tiles bins; do
    check "those that $engine casts are" same 08-fast --engine $engine -s 160x120 -o
done

check 'and shaded, by its hierarchy' same 08-fast --shaded --depth 2 -s 80x60 -o

# Beside the reference's numbers nothing is called wrong.
no_figure_differs() {
    for layout in chapters/*/figures/*.gp; do
        stem=${layout#chapters/} name=${layout##*/}
        stem=${stem%%/*} name=${name%.gp}
        "$right/$stem" --figure "$name" >"$scratch/right.gp" &&
            "$free/$stem" --figure "$name" --beside "$scratch/right.gp" >"$scratch/free.gp" || return 1
        ! grep -q '^wrong = 1' "$scratch/free.gp" || { echo "$name: something is called wrong"; return 1; }
    done
}
check 'and no figure calls them wrong' no_figure_differs

# ---- 08 draws what the answers say ----------------------------------------------------------------

# Each function that the engines compute many at a time is changed, so that it shows.
three=chapters/06-ray-casting/three-spheres.nff
shaded() { # PROGRAM ARGUMENTS...
    program=$1
    shift
    "$free/$program" "$@" --depth 2 -s 80x60 -o "$scratch/$program.png" $three >"$scratch/said" 2>&1
}
cp solutions/*.c "$answers"
follows() { # STEM SED
    sed "$2" "solutions/$1.c" >"$answers/$1.c" && ! cmp -s "solutions/$1.c" "$answers/$1.c" &&
        make -s ANSWERS="$answers" "$free/07-shading" "$free/08-fast" >"$scratch/said" 2>&1 &&
        shaded 07-shading && shaded 08-fast --shaded && cmp "$scratch/07-shading.png" "$scratch/08-fast.png" &&
        ! same_picture "$scratch/right-shaded.png" "$scratch/08-fast.png"
    status=$?
    cp "solutions/$1.c" "$answers"
    return $status
}
"$right/07-shading" --depth 2 -s 80x60 -o "$scratch/right-shaded.png" $three >"$scratch/said" 2>&1
while read -r stem name sed; do
    check "with another $name, 08's shaded picture is 07's" follows "$stem" "$sed"
done <<'CHANGES'
05-quadratic hit_sphere s/return roots.t.i.;/return 0.99 * roots.t[i];/
07-shading surface_normal s/vec3_unit(point - sphere.center)/vec3_unit(point - sphere.center + vec3_of(0, 0.1, 0))/
07-shading offset_from_surface s/0x1p-30/0.01/
07-shading mirror_direction s/direction - 2 /direction - 1.9 /
07-shading ray_to_light s/: light.position - from/: light.position + vec3_of(1, 0, 0) - from/
07-shading shade s/phong_term(surface/halfway_term(surface/
07-shading ambient s/    return sum;/    return 0.9 * sum;/
07-shading clamp_color s/fmin(1, fmax(0, color.i.))/color[i] \/ (1 + color[i])/
CHANGES
finish free_answers
