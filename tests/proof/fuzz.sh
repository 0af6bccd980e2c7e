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
sed -n "/^[a-z]/ { s/VIEW/v\\\\nfrom 0 0 5\\\\nat 0 0 0\\\\nup 0 1 0\\\\nangle 45\\\\nresolution 8 6\\\\n/
    s/BLANKS/$(printf '%1000s' '')/; p; }" tests/proof/fuzz-scenes.txt |
    while read -r name text; do printf '%b' "$text" >"$scratch/scenes/$name.nff"; done
check "the scene reader survives $seconds s of fuzzing" runs SCENES "$scratch/scenes" common/scene.c
# One case for each recorded text.
mkdir "$scratch/cases"
csplit -s -z -n 3 -f "$scratch/cases/" tests/explain/cases.txt '/^== /' '{*}'
check 'the fuzz target of the explainer builds' \
    builds COMPILERS tests/explain/[!m]*.c
check "the explainer survives $seconds s of fuzzing" runs COMPILERS "$scratch/cases" tests/explain/*.c
cat "$scratch/tried"
finish fuzz
