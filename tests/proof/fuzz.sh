#!/bin/sh
# fuzz.sh - what a fuzzer thinks of (tests/proof/fuzz), FUZZ_SECONDS long each: the scene reader, and the
# explainer of a compiler's words.
# Only reads the tree.
set -u
. tests/house/runner/library.sh
seconds=${FUZZ_SECONDS:-60}
if ! echo 'int LLVMFuzzerTestOneInput(const char *d, unsigned long n) { return !d && n; }' |
    clang -fsanitize=fuzzer -x c - -o "$scratch/try" >/dev/null 2>&1; then
    skip fuzz "fuzz: clang's libFuzzer is missing ('make setup FOR=contributor' installs it)"
fi
# builds NAME SOURCE...
builds() {
    target=$1
    shift
    clang -std=c11 -D_DEFAULT_SOURCE -Wno-psabi -I. -g -O1 \
        -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -o "$scratch/$target" \
        "tests/proof/fuzz/$target.c" "$@" -lm -pthread
}
# New finds go to the scratch folder; the kept corpus is only read: runs NAME DICTIONARY CORPUS
runs() {
    mkdir "$scratch/new-$1"
    "$scratch/$1" -max_total_time="$seconds" -max_len=4096 -dict="tests/proof/fuzz/$2" \
        -artifact_prefix="$scratch/" -print_final_stats=1 "$scratch/new-$1" "$3" \
        2>"$scratch/log" || { tail -n 40 "$scratch/log"; return 1; }
    sed -n 's/^stat::number_of_executed_units: */+ fuzz: inputs tried: /p' "$scratch/log" >>"$scratch/tried"
}
check 'the fuzz target of scenes builds' \
    builds scene common/scene.c common/nff_*.c common/text.c common/answers.c common/workers.c common/large_pages.c
check "the scene reader survives $seconds s of fuzzing" runs scene nff.dict tests/proof/fuzz/corpus
# One case for each recorded text.
mkdir "$scratch/cases"
cat tests/course/explained/*.txt | csplit -s -z -n 3 -f "$scratch/cases/" - '/^== /' '{*}'
check 'the fuzz target of the explainer builds' \
    builds explain tests/course/explain_[!m]*.c tests/course/explain_me*.c tests/course/explain_mi*.c
check "the explainer survives $seconds s of fuzzing" runs explain explain.dict "$scratch/cases"
cat "$scratch/tried"
finish fuzz
