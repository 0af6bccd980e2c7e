#!/bin/sh
# fuzz.sh - what a fuzzer thinks of (tests/proof/fuzz.c), FUZZ_SECONDS long each: the scene reader, and the
# explainer of a compiler's words.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
seconds=${FUZZ_SECONDS:-60}
if ! echo 'int LLVMFuzzerTestOneInput(const char *d, unsigned long n) { return !d && n; }' |
    clang -fsanitize=fuzzer -x c - -o "$scratch/try" >/dev/null 2>&1; then
    skip fuzz "fuzz: clang's libFuzzer is missing ('make setup FOR=contributor' installs it)"
fi
# builds NAME SOURCE...
builds() {
    target=$1
    shift
    clang -std=c11 -D_DEFAULT_SOURCE -Wno-psabi -I. -g -O1 "-D$target" \
        -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -o "$scratch/$target" \
        tests/proof/fuzz.c "$@" -lm -pthread
}
# The dictionary is the strings of the code. New finds go to the scratch folder: runs NAME CORPUS SOURCE...
runs() {
    target=$1
    corpus=$2
    shift 2
    mkdir "$scratch/new-$target"
    grep -oh '"[^"\\%]\{1,60\}"' "$@" | sort -u >"$scratch/dictionary"
    "$scratch/$target" -max_total_time="$seconds" -max_len=4096 -dict="$scratch/dictionary" \
        -artifact_prefix="$scratch/" -print_final_stats=1 "$scratch/new-$target" "$corpus" \
        2>"$scratch/log" || { tail -n 40 "$scratch/log"; return 1; }
    sed -n 's/^stat::number_of_executed_units: */+ fuzz: inputs tried: /p' "$scratch/log" >>"$scratch/tried"
}
check 'the fuzz target of scenes builds' \
    builds SCENES common/scene.c common/text.c common/answers.c common/failed_check.c
mkdir "$scratch/scenes"
# To begin with: one scene with everything, one with a line that is too long, and what is no scene.
everything='v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nresolution 8 6\nb 0 0 1\nl 1 2 3\nl 3 2 1 1 0.5 0
f 1 0 0 0.8 0.2 10 0 1\ns 0 0 0 1\nc\n0 0 0 1\n0 1 0 0\np 3\n0 0 0\n1 0 0\n1 1 0\n'
printf '%b' "$everything" >"$scratch/scenes/everything.nff"
printf '%b#%1000s\n' "$everything" '' >"$scratch/scenes/long-line.nff"
printf '\357\273\277# x\r\nv 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17\r\np 2147483647\n\0' >"$scratch/scenes/none.nff"
check "the scene reader survives $seconds s of fuzzing" runs SCENES "$scratch/scenes" common/scene.c
# One case for each recorded text.
mkdir "$scratch/cases"
csplit -s -z -n 3 -f "$scratch/cases/" tests/explain/cases.txt '/^== /' '{*}'
check 'the fuzz target of the explainer builds' \
    builds COMPILERS tests/explain/[!m]*.c
check "the explainer survives $seconds s of fuzzing" runs COMPILERS "$scratch/cases" tests/explain/*.c
cat "$scratch/tried"
finish fuzz
