#!/bin/sh
# handout.sh - the students' archive: what is in it, what is not, and that it is the same each time.
set -u
. tests/library.sh

archive=build/handout.tar.gz
make_handout() {
    make --no-print-directory -s handout
}
# The archive unpacked, and the names in it.
look_into() {
    rm -rf "$scratch/tree" && mkdir "$scratch/tree" && tar xzf "$1" -C "$scratch/tree" &&
        tar tzf "$1" >"$scratch/names"
}
none_of_these() {
    ! grep -E "$1" "$scratch/names"
}
# No file of the handout, but for the lessons, has any of these lines (fixed strings).
holds_none_of() {
    [ -s "$1" ] || { echo "nothing to look for"; return 1; }
    ! find "$scratch/tree" -type f ! -path '*/chapters/*/README.md' \
        -exec grep -aHFf "$1" {} +
}

check 'make handout makes the archive' make_handout
cp "$archive" "$scratch/first.tar.gz"
check 'it can be unpacked' look_into "$archive"
check 'a second one has the same bytes' eval 'make_handout && cmp "$archive" "$scratch/first.tar.gz"'
check 'so has one that an answer in exercises/ was made beside' eval '
    cp exercises/01-corners.c "$scratch/kept.c" &&
    echo "// my answer" >>exercises/01-corners.c && make_handout
    cp "$scratch/kept.c" exercises/01-corners.c && cmp "$archive" "$scratch/first.tar.gz"'
check 'names are sorted and of one folder' eval '
    LC_ALL=C sort -c "$scratch/names" && ! grep -v "^ray-casting/" "$scratch/names"'
check 'nobody owns it, and no date is of today' eval '
    tar tvzf "$archive" --numeric-owner >"$scratch/long" &&
    ! grep -v " 0/0 " "$scratch/long" && [ "$(awk "{ print \$4, \$5 }" "$scratch/long" | sort -u | wc -l)" -eq 1 ]'
check 'the date can be said' eval '
    SOURCE_DATE_EPOCH=86400 make_handout && tar tvzf "$archive" | grep -q 1970-01-02'
check 'and changed back' eval 'make_handout && cmp "$archive" "$scratch/first.tar.gz"'

check 'there are no solutions in it' none_of_these 'solutions'
check 'nor tests of the chapters' none_of_these '/tests/[0-9][0-9]-'
check 'nor mistakes, variants, laws' none_of_these '/tests/(mistakes|variants|laws|exact)'
check 'nor what makes the tables' none_of_these '/tests/told/(tell|here|variants)|matrix'
check 'nor graders, benches and the like' none_of_these \
    '/tests/(shell|long|benches|fuzz|grading|hostile)|\.git/|\.ci/|CONTRIBUTING'

for solution in solutions/*.c; do
    stem=$(basename "$solution" .c)
    awk '/BEGIN SOLUTION/ { inside = 1; next } /END SOLUTION/ { inside = 0 } inside && !/\/\/~/' \
        "$solution" | sed 's/^ *//; s/ *$//' | awk 'length > 25' |
        grep -vxFf exercises/"$stem".h >>"$scratch/lines"
done
# What a blank gives, everybody has.
sed 's/^ *//; s/ *$//' build/blanks/*.c | awk 'length > 25' >"$scratch/given"
grep -vxFf "$scratch/given" "$scratch/lines" >"$scratch/secret"
check 'no line of a solution is in it' holds_none_of "$scratch/secret"
for teller in build/told/tell/*; do
    "$teller" --formulas
done | awk 'length > 5' | sort -u >"$scratch/formulas"
check 'no formula of a mistake is in it' holds_none_of "$scratch/formulas"
check 'a lesson calls programs where they are' eval '
    ! grep -r "build/solutions" "$scratch/tree"'

links_lead_somewhere() {
    status=0
    for page in "$scratch"/tree/ray-casting/README.md "$scratch"/tree/ray-casting/chapters/*/README.md; do
        # shellcheck disable=SC2013 # links have no blanks
        for link in $(grep -o '](\([^)#]*\)' "$page" | sed 's/^](//' | grep -v '^http'); do
            [ -e "$(dirname "$page")/$link" ] || { echo "$page: $link"; status=1; }
        done
    done
    return $status
}
check 'the links of its pages lead somewhere' links_lead_somewhere

marked() {
    printf '%s\n' 'a' '#[ why' 'b' '#]' '#~ c' '<!--[ why -->' 'd' '<!--] -->' '<!--~ e -->' |
        awk -f .make/handout.awk | tr -d '\n' | grep -qx ace
}
check 'what is between marks is left out, what is behind them is taken' marked
check 'marks that do not match are refused' eval '! echo "#[" | awk -f .make/handout.awk'

finish handout
