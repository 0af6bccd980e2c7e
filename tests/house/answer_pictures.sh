#!/bin/sh
# answer_pictures.sh - the pictures that a student's answers draw before all is right, the words about
# them, and how far all chapters are.
# Builds only below its answers.
set -u
. tests/house/runner/library.sh
ordinary answer_pictures "the pictures of answers"

answers=$scratch/answers
export NO_COLOR=1 COLUMNS=400 # the words about a picture are one line
so_far=build$answers/so-far
judge() {
    exercises "$answers" "$@" >"$scratch/said" 2>&1
}
# A folder of blanks, but for these solutions.
answered() {
    rm -rf "$answers" "build$answers"
    mkdir "$answers"
    cp build/blanks/*.c "$answers"
    for stem in "$@"; do
        cp "solutions/$stem.c" "$answers"
    done
}
# Chapter 07 with only one function answered, as a sed command changes it.
only() {
    answered
    awk -v name="$1" '
        /^[A-Za-z].*\(.*\)$/ { split($0, words, "("); sub(/.*[ *]/, "", words[1]); inside = words[1] }
        FNR == NR && inside { blank[inside] = blank[inside] $0 "\n" }
        FNR != NR && !(inside in blank && inside != name)
        /^}/ { if (FNR != NR && inside in blank && inside != name) printf "%s", blank[inside]; inside = "" }
        ' build/blanks/07-shading.c solutions/07-shading.c | sed "${2:-}" >"$answers/07-shading.c"
    judge EX=07
}
same() {
    cmp "$so_far/$1.png" "$2"
}
differ() {
    [ -s "$so_far/$1.png" ] && ! cmp -s "$so_far/$1.png" "$2"
}

answered
judge EX=01
check 'blanks draw nothing' test ! -e "$so_far"
check 'and none of all functions is right' says 'all chapters     0 of '

answered 01-corners
judge EX=01
check 'after 01 there are spheres' test -s "$so_far/01-spheres.png"
check 'its place is printed' says "picture    $so_far/01-spheres.png"
check 'and what is theirs' says 'Yours: image_plane_vector. Given, from the reference: the colour seen in each direction.'
check 'and the chapter has its own picture' says "drawn by your own code: build$answers/gallery/01-corners.png"
check 'those that are right are counted' says 'all chapters     5 of '
cp "$so_far/01-spheres.png" "$scratch/right.png"
status_counts() {
    make --no-print-directory status EX=02 ANSWERS="$answers" >"$scratch/said" 2>&1
    says "all chapters		5 of $(grep -c '^EXERCISE(' tests/exercises.def) functions are right"
}
check 'status counts them over all chapters' status_counts

# Through the camera of a look-at that is the same camera, the same is seen.
cp solutions/02-cameras.c "$answers"
judge EX=02
check 'a look-at sees the same spheres' same 02-spheres "$scratch/right.png"

# The same rays: of vectors through the centres of pixels, or as rays.
cp solutions/03-screen.c solutions/04-pixel-ray.c "$answers"
judge EX=03
judge EX=04
check 'places and rays see the same' same 03-spheres "$so_far/04-spheres.png"

answered
sed 's/(s - 0.5)/(0.5 - s)/' solutions/01-corners.c >"$answers/01-corners.c"
judge EX=01
check 'a wrong answer draws its picture' differ 01-spheres "$scratch/right.png"
check 'and the words say that it is wrong' says 'Yours, not right yet: image_plane_vector.'
check 'once' [ "$(grep -c so-far "$scratch/said")" -eq 1 ]

answered 02-cameras
judge EX=02
check 'without 01 the reference takes its place, and the words say so' says 'Yours: camera_from_look_at. By the reference: image_plane_vector.'
check 'and the spheres are there' same 02-spheres "$scratch/right.png"

answered
sed 's/return c.distance \* c.forward + (s/for (volatile int i = 0; i < 1; i *= 2);\n    &/' solutions/01-corners.c >"$answers/01-corners.c"
judge EX=01
check 'what does not come back draws nothing' test ! -e "$so_far/01-spheres.png"

# Each function of chapter 07 has its picture as soon as it is answered.
for pair in surface_normal:normals diffuse_term:diffuse phong_term:highlights visibility:shadows trace_ray:mirrors; do
    only "${pair%:*}"
    check "${pair%:*} draws its picture" test -s "$so_far/07-${pair#*:}.png"
    check 'and no other' [ "$(ls "$so_far")" = "07-${pair#*:}.png" ]
    check 'the rest is by the reference' says 'By the reference: '
done
judge EX=07
check 'what was right before is not shown again' says_not 'so-far'
only diffuse_term 's/fmax(0, cosine)/cosine/; s/kd \* cosine/cosine/'
check 'a wrong term draws its picture' says "so-far/07-diffuse.png"
check 'each time' says 'Yours, not right yet: diffuse_term.'

# A rectangle is drawn around each sphere; a smaller one is another picture.
answered 08-fast
judge EX=08
cp "$so_far/08-rectangles.png" "$scratch/rectangles.png"
sed '/^ScreenRectangle sphere_rectangle/,/^}/s/sphere.radius/(0.5 * sphere.radius)/g' solutions/08-fast.c >"$answers/08-fast.c"
judge EX=08
check 'wrong rectangles are drawn' differ 08-rectangles "$scratch/rectangles.png"

# All is right: the deck's last slide now, and the picture of README.md by a command, because it takes
# longer and this is not a terminal.
answered
cp solutions/*.c "$answers"
judge
check 'all of all functions are right' says "all chapters     $(grep -c '^EXERCISE(' tests/exercises.def) of $(grep -c '^EXERCISE(' tests/exercises.def) functions are right"
check 'and the end of the road is reported' says 'You have written a ray caster.'
check 'with its picture' says "build$answers/gallery/still-something-missing.png"
check 'the last slide is drawn' test -s "build$answers/gallery/still-something-missing.png"
check 'the picture of README.md has its command' says "make finale ANSWERS=$answers"
finale_is_made() {
    make --no-print-directory -n finale ANSWERS="$answers" >"$scratch/said" 2>&1 && says "build$answers/gallery/finale.png"
}
check 'which make knows' finale_is_made

# The programs that make starts between a saved right answer and its verdict with its pictures.
starts_at_most() {
    answered 01-corners
    judge EX=01
    echo '// saved' >>"$answers/01-corners.c"
    strace -f -e trace=execve -o "$scratch/started" make --no-print-directory exercises EX=01 ANSWERS="$answers" >/dev/null 2>&1
    count=$(grep -c 'execve(.*= 0$' "$scratch/started")
    echo "$count programs were started"
    [ "$count" -gt 5 ] && [ "$count" -le "$1" ]
}
if strace -o /dev/null true 2>/dev/null && [ -z "${SANITIZE:-}" ]; then
    check 'a saved answer starts at most 20 programs' starts_at_most 20
else
    echo 'skipped: counting programs needs strace'
fi

rm -rf "build$answers"
finish answer_pictures
