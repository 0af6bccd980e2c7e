#!/bin/sh
# examples.sh - a lecture with other numbers. In a copy of the tree, chapters/example.h gets random ones
# (random_example.c), 'make' runs, and then nothing disagrees: the reference passes, lessons and figures
# have the new numbers, and the tests of the lessons pass.
# EXAMPLES=20 in the environment says how many; FIRST_EXAMPLE=1 with which to begin.
# Only reads the tree.
set -u
. tests/house/runner/library.sh
once examples 'lectures with other numbers'
needs examples 'figures with other numbers' gnuplot

examples=${EXAMPLES:-20}
first=${FIRST_EXAMPLE:-1}
random=$BUILD/tests/proof/random_example
tree=$scratch/tree
mkdir "$tree"
# With their dates, so that make builds only what depends on the example.
git ls-files -z --cached --others --exclude-standard | xargs -0 cp -p --parents -t "$tree" 2>/dev/null
mkdir -p "$tree/$BUILD" && cp -a "$BUILD/." "$tree/$BUILD/"
cd "$tree" || exit 1
cp -r chapters "$scratch/chapters"
unset MAKEFLAGS ANSWERS
export MOST_BYTES=200000 # of a picture: if the camera is turned, its colours take more
export PROGRAMS="$BUILD/solutions"

# What a lecturer runs, and then what the tests below need. The second one has nothing to write.
with_the_numbers_of() {
    "$random" "$1" >chapters/example.h || return 1
    make CC="$CC" >"$scratch/made" 2>&1 && cp chapters/01-corners/README.md "$scratch/lesson" &&
        make CC="$CC" lessons "$BUILD/solutions/tests" "$BUILD/tests/house/common/example" >>"$scratch/made" 2>&1 &&
        cmp chapters/01-corners/README.md "$scratch/lesson" && return
    tail -n 20 "$scratch/made"
    return 1
}
holds_its_numbers() {
    "$random" "$1" --lessons | while IFS='	' read -r lesson text other; do
        grep -qF -e "$text" -e "${other:-$text}" "$lesson" || { echo "$lesson does not have: $text"; break; }
    done >"$scratch/missing"
    cat "$scratch/missing"
    [ ! -s "$scratch/missing" ]
}
# The figures without options are those with the example's numbers as options.
draws_its_numbers() {
    "$random" "$1" --figures >"$scratch/figures" && [ -s "$scratch/figures" ] || return 1
    while read -r program figure options; do
        "$PROGRAMS/$program" --figure "$figure" >"$scratch/default.gp" || return 1
        # shellcheck disable=SC2086 # options are words
        "$PROGRAMS/$program" --figure "$figure" $options >"$scratch/given.gp" || return 1
        cmp "$scratch/default.gp" "$scratch/given.gp" || { echo "$program $figure $options"; return 1; }
    done <"$scratch/figures"
}

number=$first
while [ "$number" -lt $((first + examples)) ]; do
    check "make has the numbers of example $number everywhere" with_the_numbers_of "$number"
    check 'it is an example' "$BUILD/tests/house/common/example"
    for contract in exercises/*.h; do
        stem=$(basename "$contract" .h)
        check "example $number: the reference of $stem passes" "$BUILD/solutions/tests" "$stem"
    done
    check "example $number: the lessons have its numbers" holds_its_numbers "$number"
    check "example $number: the figures have its numbers" draws_its_numbers "$number"
    check "example $number: the tests of the lessons pass" sh tests/house/lessons.sh
    check "example $number: the lessons show the figures that are drawn" \
        "$BUILD/tests/house/figures/lesson_figures" "$PROGRAMS/figures" chapters/[0-9]*
    check "example $number: the lessons show the pictures that are drawn" sh tests/house/lesson_pictures.sh
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
#define EXAMPLE_UP 0, 0, 0' 'this is not a camera: right, up and forward must each have length 1'
    cp "$scratch/chapters/example.h" chapters/
    check 'with the old numbers, make writes' make CC="$CC"
    # Pictures are the same pixels; libpng packs them in its own way.
    check 'the old lessons and figures' diff -r -x '*.png' "$scratch/chapters" chapters
    check 'the old pictures' sh tests/house/lesson_pictures.sh
fi
finish examples
