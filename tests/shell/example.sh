#!/bin/sh
# example.sh - what the instructor's page says of the ten submissions is what 'make grade' says.
set -u
. tests/library.sh
needs_grading example 'the example of grading'
page=tests/grade/README.md
example=tests/grade/example
out=$scratch/out

make -s --no-print-directory grade SUBMISSIONS=$example/class POLICY=$example/policy OUT="$out" \
    SEED=2015 >"$scratch/closing" 2>"$scratch/progress"
status=$?
ends_well() {
    cat "$scratch/progress"
    [ "$status" -eq 0 ]
}
check 'make grade grades the example' ends_well

# Block N of the page's ```text blocks.
block() {
    awk -v n="$1" '/^```text$/ { inside = ++count == n; next } /^```/ { inside = 0 } inside' $page
}

# But for the sandbox of this machine, and what came after.
as_everywhere() {
    sed -n '/^Took/q; s/Sandbox: .*/Sandbox: (any)/; p' "$1" | sed -e :a -e '/^\n*$/ { $d; N; ba' -e '}'
}
closing_is_quoted() {
    block 1 >"$scratch/quoted"
    [ -s "$scratch/quoted" ] || { echo 'no ```text block'; return 1; }
    as_everywhere "$scratch/quoted" >"$scratch/quoted.any"
    as_everywhere "$scratch/closing" | diff "$scratch/quoted.any" -
}
check 'the page quotes what the terminal says' closing_is_quoted

# Everything that students are told, as plain text.
told() {
    python3 - "$out" <<'PYTHON'
import json, pathlib, sys
for path in sorted(pathlib.Path(sys.argv[1]).glob("*/results.json")):
    results = json.loads(path.read_text())
    print(results["output"])
    for test in results["tests"]:
        print(test["output"])
PYTHON
}
comments_are_quoted() {
    told >"$scratch/told"
    block 2 >"$scratch/quoted"
    [ -s "$scratch/quoted" ] || { echo 'no second ```text block'; return 1; }
    ! grep -vxFf "$scratch/told" "$scratch/quoted"
}
check 'the page quotes what students are told' comments_are_quoted

# The page's table: | name | status | score | why |
marks_are_explained() {
    # shellcheck disable=SC2016 # the backquotes are the page's
    sed -n 's/^| `\([a-z-]*\)` | \([a-z ]*\) | \([0-9]*\) |.*/\1,\2,\3/p' $page | sort >"$scratch/explained"
    [ "$(wc -l <"$scratch/explained")" -eq 10 ] || { echo 'not ten submissions'; return 1; }
    sed 1d "$out/grades.csv" | cut -d, -f1-3 | sort | diff "$scratch/explained" -
}
check 'the marks are those that the page explains' marks_are_explained

# The example has failures; prove must read them all.
prove_reads() {
    prove "$out/grades.tap" >"$scratch/proved" 2>&1
    cat "$scratch/proved"
    grep -q '^Files=1, Tests=[1-9]' "$scratch/proved" && ! grep -q 'Parse errors' "$scratch/proved"
}
if command -v prove >/dev/null; then
    check 'prove reads grades.tap' prove_reads
else
    echo "skipped: grades.tap by prove (no prove)"
fi

links_lead_somewhere() {
    # shellcheck disable=SC2013 # links have no blanks
    for link in $(grep -o '](\([^)#]*\)' "$1" | sed 's/^](//' | grep -v '^http'); do
        [ -e "$(dirname "$1")/$link" ] || { echo "$link"; return 1; }
    done
}
check "the page's links lead somewhere" links_lead_somewhere $page
check "and those of the recipes" links_lead_somewhere tests/grade/recipes/README.md
speaks_of_each() {
    for recipe in tests/grade/recipes/*.yml tests/grade/recipes/gradescope/*; do
        grep -qF "](${recipe#tests/grade/recipes/})" tests/grade/recipes/README.md ||
            { echo "$recipe"; return 1; }
    done
}
check 'the page of recipes speaks of each' speaks_of_each
fits() {
    ! awk 'length > 80 { print FILENAME ": " FNR; found = 1 } END { exit !found }' $page tests/grade/recipes/README.md
}
check 'the page fits a terminal' fits
has_windows_line_ends() {
    grep -q "$(printf '\r')" $example/class/deep-folder/*/*/01-corners.c
}
check 'the example still has its Windows line ends' has_windows_line_ends

finish example
