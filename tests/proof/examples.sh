#!/bin/sh
# examples.sh - a lecture with other numbers. In a copy of the tree, chapters/example.h gets random ones
# (random_example.py), 'make' runs, and then nothing disagrees: the reference passes, lessons and figures
# have the new numbers, and the tests of the lessons pass.
# EXAMPLES=20 in the environment says how many; FIRST_EXAMPLE=1 with which to begin.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once examples 'lectures with other numbers'
needs examples 'figures with other numbers' gnuplot python3

examples=${EXAMPLES:-20}
first=${FIRST_EXAMPLE:-1}
random_example() {
    PYTHONPATH=$here/tests/house/figures python3 "$here/tests/proof/random_example.py" "$@"
}
tree=$scratch/tree
mkdir "$tree"
# With their dates, so that make builds only what depends on the example.
git ls-files -z --cached --others --exclude-standard | xargs -0 cp -p --parents -t "$tree" 2>/dev/null
mkdir -p "$tree/$BUILD" && cp -a "$BUILD/." "$tree/$BUILD/"
cd "$tree" || exit 1
cp -r chapters "$scratch/chapters"
unset MAKEFLAGS ANSWERS
export MOST_BYTES=200000 # of a picture: if the camera is turned, its colors take more
export PROGRAMS="$BUILD/solutions"

# What a lecturer runs, and then what the tests below need. The second one has nothing to write.
with_the_numbers_of() {
    random_example "$1" >chapters/example.h || return 1
    make CC="$CC" >"$scratch/made" 2>&1 && cp chapters/01-corners/README.md "$scratch/lesson" &&
        make CC="$CC" lessons "$BUILD/solutions/tests" >>"$scratch/made" 2>&1 &&
        cmp chapters/01-corners/README.md "$scratch/lesson" && return
    tail -n 20 "$scratch/made"
    return 1
}
holds_its_numbers() {
    random_example "$1" --lessons | while IFS='	' read -r lesson texts; do
        printf '%s\n' "$texts" | tr '\t' '\n' | grep -qFf - "$lesson" || { echo "$lesson does not have: ${texts%%	*}"; break; }
    done >"$scratch/missing"
    cat "$scratch/missing"
    [ ! -s "$scratch/missing" ]
}
# The figures without options are those with the example's numbers as options.
draws_its_numbers() {
    random_example "$1" --figures >"$scratch/figures" && [ -s "$scratch/figures" ] || return 1
    while read -r program figure options; do
        "$PROGRAMS/$program" --figure "$figure" >"$scratch/default.gp" || return 1
        # shellcheck disable=SC2086 # options are words
        "$PROGRAMS/$program" --figure "$figure" $options >"$scratch/given.gp" || return 1
        cmp "$scratch/default.gp" "$scratch/given.gp" || { echo "$program $figure $options"; return 1; }
    done <"$scratch/figures"
}

# Pictures in every format, a figure from a folder, an animation and slides: after a change of the example, each is of
# the new numbers or is gone.
is_drawn_before() {
    mkdir "$scratch/own" && { echo '# data: parabola'; cat chapters/05-quadratic/figures/parabola.gp; } >"$scratch/own/own-parabola.gp"
    for folder in animations/discriminant slides; do
        mkdir -p "$PROGRAMS/$folder" && touch "$PROGRAMS/$folder/discriminant.gp" "$PROGRAMS/$folder/old.mp4" "$PROGRAMS/$folder/old.pdf"
    done
    rm "$PROGRAMS"/slides/*.[mg]p*
    make CC="$CC" figures FIGURE=parabola FORMAT=svg,pdf,png,tex SHAPE=16:9,4:3 STEPS=1 &&
        make CC="$CC" figures FIGURES="$scratch/own" && [ -s "$PROGRAMS/figures/own-parabola/own-parabola.pdf" ]
}
nothing_is_older() {
    [ -s "$PROGRAMS/figures/parabola/parabola.svg" ] || return 1
    find "$PROGRAMS"/figures/*parabola "$PROGRAMS/animations" "$PROGRAMS/slides" -name '[!.]*.*' -type f \
        ! -path '*/.work/*' ! -name 'numbers*' ! -newer chapters/example.h >"$scratch/older"
    cat "$scratch/older"
    [ ! -s "$scratch/older" ]
}
check 'there are pictures in every format' is_drawn_before
# The figures that the lecturer's page says have a scene of their own are those that do not follow the example.
cp -r "$PROGRAMS/figures" "$scratch/figures-before"
# shellcheck disable=SC2016 # they are letters
figures_that_stayed() {
    for script in chapters/0?-*/figures/*.gp; do
        name=$(basename "$script" .gp)
        ! cmp -s "$scratch/figures-before/$name/$name.gp" "$PROGRAMS/figures/$name/$name.gp" || echo "$name"
    done | sort >"$scratch/stayed"
    sed -n '/^These figures have a scene of their own/,/^$/p' chapters/README.md | tr '\n' ' ' | sed 's/.*`discriminant`://' |
        grep -o '`[^`]*`' | tr -d '`' | sort | diff - "$scratch/stayed"
}
# What the notes say of the example's numbers. A point and the center of its pixel are said to be two places: they look
# different, however large the screen is.
mkdir -p "$scratch/new/chapters" "$scratch/slides"
says_on_slides() {
    random_example "$1" >"$scratch/new/chapters/example.h" && random_example "$1" --slides >"$scratch/wanted" &&
        "${CC:-cc}" -std=c11 -D_DEFAULT_SOURCE -Wno-psabi "-I$scratch/new" -I. -o "$scratch/numbers" "$BUILD/chapters/02-cameras/forms.o" \
            "$BUILD"/chapters/lessons/*numbers.o chapters/shared/example.c "$PROGRAMS"/0?-*.o "$BUILD/chapters/shared.a" \
            "$BUILD/common.a" -lm &&
        "$scratch/numbers" >"$scratch/slides/$1.json" || return 1
    while IFS= read -r line; do
        grep -qF -e "$line" "$scratch/slides/$1.json" || { echo "example $1: no $line"; return 1; }
    done <"$scratch/wanted"
    point=$(grep -o '"point_normalized": "[^"]*"' "$scratch/slides/$1.json" | cut -d '(' -f 2)
    pixel=$(grep -o '"pixel_normalized": "[^"]*"' "$scratch/slides/$1.json" | cut -d '(' -f 2)
    echo "$point $pixel"
    [ "${point%,*}" != "${pixel%,*}" ] && [ "${point#*,}" != "${pixel#*,}" ]
}
for number in 0 1 2 3 4 5 6 7 8 $(seq 1000 $((999 + ${MOST_EXAMPLES:-500}))); do
    check "the notes of the slides say what holds for example $number" says_on_slides "$number"
done
# slides_fit SHAPE KIND: of some of these examples, all slides with numbers, or their notes.
slides_fit() {
    python3 tests/proof/slides/example_slides.py chapters/slides.txt "$scratch"/slides/?.json "$scratch"/slides/1*[05].json >"$scratch/slides/some.txt" &&
        python3 chapters/slides/make_slides.py "$scratch/slides/some.txt" "$scratch/slides/0.json" "$3" "$1" "$2" "$scratch/slides/$2.pdf" &&
        ! grep -A 3 Overfull "$scratch/slides/.work/$2/$2.log"
}
if python3 chapters/slides/make_slides.py --ready >/dev/null 2>&1; then
    check 'nothing is too wide or too high for the slides in 4:3' slides_fit 4:3 light "$scratch/slides"
    check 'nor in 16:9' slides_fit 16:9 light "$scratch/slides"
    check 'nor for the notes' slides_fit 16:9 notes "$scratch/slides/light.pdf"
else
    echo "skipped: slides of these examples, which need LaTeX (make setup FOR=lecturer)"
fi
number=$first
while [ "$number" -lt $((first + examples)) ]; do
    check "make has the numbers of example $number everywhere" with_the_numbers_of "$number"
    check 'nothing with older numbers is beside them' nothing_is_older
    check 'the page names the figures that do not follow it' figures_that_stayed
    for contract in exercises/*.h; do
        stem=$(basename "$contract" .h)
        check "example $number: the reference of $stem passes" "$BUILD/solutions/tests" "$stem"
    done
    check "example $number: the lessons have its numbers" holds_its_numbers "$number"
    check "example $number: the figures have its numbers" draws_its_numbers "$number"
    check "example $number: the tests of the lessons pass" env DRAWN="$PROGRAMS/figures" sh tests/house/lessons.sh
    number=$((number + 1))
done

# Numbers that are not an example are refused, and no lesson changes. Then back to the numbers of the tree:
# everything is again as it was.
refuses() {
    cp -r chapters "$scratch/kept" && echo "$1" >>chapters/example.h
    make CC="$CC" lessons >"$scratch/said" 2>&1 && return 1
    diff -r -x example.h "$scratch/kept" chapters && rm -r "$scratch/kept" &&
        says "chapters/example.h: $2"
}
if [ "$examples" -gt 2 ]; then
    check 'no camera is refused' refuses '#undef EXAMPLE_UP
#define EXAMPLE_UP 0, 0, 0' 'up is (0, 0, 0): its length is 0, expected 1'
    cp "$scratch/chapters/example.h" chapters/
    check 'with the old numbers, make writes' make CC="$CC"
    # Pictures are the same pixels; libpng packs them in its own way.
    check 'the old lessons and figures' diff -r -x '*.png' "$scratch/chapters" chapters
    check 'the old pictures' env DRAWN="$PROGRAMS/figures" sh tests/house/lessons.sh
fi
finish examples
