#!/bin/sh
# lessons.sh - what the lessons say of the programs is what the programs say.
# Only reads the tree.
set -u
. tests/house/runner/library.sh

# The lines of the lesson's ```text blocks, all of which the chapter's program must print.
quotes_its_program() {
    "$PROGRAMS/$1" >"$scratch/printed" || return 1
    awk '/^```text$/ { inside = 1; next } /^```/ { inside = 0 } inside && NF' \
        "chapters/$1/README.md" >"$scratch/quoted"
    [ -s "$scratch/quoted" ] || { echo "no \`\`\`text block"; return 1; }
    ! grep -vxFf "$scratch/printed" "$scratch/quoted"
}

links_lead_somewhere() {
    folder=$(dirname "$1")
    status=0
    # shellcheck disable=SC2013 # links have no blanks
    for link in $(grep -o '](\([^)#]*\)' "$1" | sed 's/^](//' | grep -v '^http'); do
        [ -e "$folder/$link" ] || { echo "$link"; status=1; }
    done
    return $status
}

# Both ends of the world: the deck's numbers, with no arguments, and a story that ends well.
tells_its_story() {
    "$PROGRAMS/$1" --help >/dev/null && ! "$PROGRAMS/$1" --no-such-option 2>/dev/null
}

for lesson in chapters/[0-9]*/README.md; do
    stem=$(basename "$(dirname "$lesson")")
    check "the lesson of $stem quotes its program" quotes_its_program "$stem"
    check "the program of $stem has help and knows its options" tells_its_story "$stem"
    check "the links of $lesson lead somewhere" links_lead_somewhere "$lesson"
done
for source in chapters/lessons/*.md; do
    stem=$(basename "$source" .md)
    check "the lesson of $stem is what 'make lessons' writes" \
        diff "$BUILD/lessons/$stem.md" "chapters/$stem/README.md"
done
for page in README.md chapters/README.md chapters/book/README.md exercises/README.md .github/CONTRIBUTING.md; do
    check "the links of $page lead somewhere" links_lead_somewhere "$page"
done

# Each picture that is drawn while a chapter is answered has its name in the lesson of that chapter.
names_its_pictures() {
    sed -n 's/^PICTURE([a-z_]*, "\([^"]*\)".*/\1/p' tests/course/pictures/pictures.def >"$scratch/pictures"
    [ -s "$scratch/pictures" ] && while IFS= read -r name; do
        grep -qF "$name.png" chapters/"${name%%-*}"-*/README.md || { echo "not there: $name.png" && return 1; }
    done <"$scratch/pictures"
}
check 'the lessons name the pictures that are drawn on the way' names_its_pictures

# The student's page says how long each chapter takes, in the words of its lesson.
says_the_time_of() {
    time=$(sed -n 's/^| time | \([^;|]*[^;| ]\).*/\1/p' "chapters/$1/README.md")
    [ -n "$time" ] && grep -F "(../chapters/$1/README.md)" exercises/README.md | grep -qF "| $time |"
}
for lesson in chapters/[0-9]*/README.md; do
    stem=$(basename "$(dirname "$lesson")")
    check "the student's page says how long $stem takes" says_the_time_of "$stem"
done

# The files that lesson 08 tells its reader to read.
files_are_there() {
    # shellcheck disable=SC2016 # these are Markdown's backquotes
    [ "$(grep -o '`[a-z_]*\.[ch]`' chapters/08-fast/README.md | tr -d '`' | sort -u | tee "$scratch/files" | wc -l)" -gt 20 ] &&
        while IFS= read -r file; do
            [ -e "chapters/08-fast/engines/$file" ] || [ -e "chapters/08-fast/$file" ] || [ -e "common/$file" ] ||
                { echo "not there: $file" && return 1; }
        done <"$scratch/files"
}
check 'the lesson of 08 names files that exist' files_are_there

# Every function of common/ that an exercise needs is described where its reader looks.
describes() {
    grep -q "$1(" common/image.h && grep -q "$1(" chapters/06-ray-casting/README.md &&
        grep -q "$1(" exercises/06-ray-casting.h
}
for name in image_set image_index; do
    check "the lesson and the contract of 06 describe $name" describes "$name"
done

# make names the folder whose path has a blank, and nothing else.
refuses_the_blank_in() {
    make "$@" help >"$scratch/printed" 2>&1 && return 1
    cat "$scratch/printed"
    grep -qF "$wanted" "$scratch/printed" && ! grep -q solutions "$scratch/printed"
}
mkdir -p "$scratch/a blank" && ln -s "$PWD/Makefile" "$scratch/a blank/Makefile"
wanted="a blank'"
check 'a space in the path of the toolkit is reported' refuses_the_blank_in -C "$scratch/a blank"
wanted="ANSWERS='a blank': expected one folder"
check 'a space in the path of the answers is reported' refuses_the_blank_in ANSWERS='a blank'

# The deck's answers, to the digit.
prints() {
    program=$1
    shift
    "$PROGRAMS/$program" "$@" >"$scratch/printed" && cat "$scratch/printed"
    grep -qF -- "$wanted" "$scratch/printed"
}
deck='--eye 2,2,-4 --right 1,0,0 --up 0,1,0 --forward 0,0,1 --distance 4 --width 2 --height 2'
wanted='upper left                  (-1, 1, 4)'
# shellcheck disable=SC2086 # options are words
check 'chapter 01 prints the upper left corner' prints 01-corners $deck
wanted='30% across, 10% up          (-0.4, -0.8, 4)'
# shellcheck disable=SC2086
check 'chapter 01 prints the point 30% across, 10% up' prints 01-corners $deck
wanted='(0.46875, 0.166667)'
check 'chapter 03 prints (300, 400) normalized' prints 03-screen --size 640x480 --point 300,400
wanted='upper left                  (-2, 1, 4)'
# shellcheck disable=SC2086
check 'chapter 01 takes the numbers of its reader' prints 01-corners $deck --width 4
wanted='right-handed                right (-1, 0, 0)'
# shellcheck disable=SC2086
check 'chapter 02 shows what the wrong hand does' prints 02-cameras $deck
wanted='3.62151'
check "chapter 05 prints the hit of the deck's arrow" \
    prints 05-quadratic -o -4,-1,0 -d 0.89,0.45,0 -c 0,0,0 -r 1

# Invalid cameras and impossible numbers are refused.
exits_with() {
    status=$1
    shift
    "$@" >"$scratch/printed" 2>&1
    found=$?
    cat "$scratch/printed"
    [ "$found" -eq "$status" ]
}
check 'chapter 01 refuses invalid cameras' exits_with 1 "$PROGRAMS/01-corners" --right 2,0,0
check 'chapter 02 refuses to look at the eye' exits_with 1 "$PROGRAMS/02-cameras" --eye 1,2,3 --at 1,2,3
check 'chapter 02 refuses options that belong to no look-at' exits_with 2 "$PROGRAMS/02-cameras" --hand left
check 'chapter 03 refuses a pixel off the screen' exits_with 2 "$PROGRAMS/03-screen" --size 4x3 --pixel 4,0
check 'chapter 04 refuses a pixel off the screen' exits_with 2 "$PROGRAMS/04-pixel-ray" --size 4x3 --pixel 0,3
check 'chapter 05 refuses a radius of 0' exits_with 2 "$PROGRAMS/05-quadratic" --radius 0
check 'chapter 05 refuses a direction of length 0' exits_with 2 "$PROGRAMS/05-quadratic" --direction 0,0,0
check 'chapter 05 refuses NaN' exits_with 2 "$PROGRAMS/05-quadratic" --radius nan
check 'chapter 03 says what it cannot write' exits_with 1 "$PROGRAMS/03-screen" --picture /no/such/folder/x.png

[ ! -c /dev/full ] ||
    check 'a story that cannot be printed ends with 1' exits_with 1 sh -c "$PROGRAMS/03-screen >/dev/full"

finish lessons
