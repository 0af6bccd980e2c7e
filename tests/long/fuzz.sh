#!/bin/sh
# fuzz.sh - the scene reader on what a fuzzer thinks of (tests/fuzz/scene.c), FUZZ_SECONDS long.
# Only reads the tree.
set -u
. tests/library.sh
seconds=${FUZZ_SECONDS:-60}
if ! echo 'int LLVMFuzzerTestOneInput(const char *d, unsigned long n) { return !d && n; }' |
    clang -fsanitize=fuzzer -x c - -o "$scratch/try" >/dev/null 2>&1; then
    skip fuzz "fuzz: clang's libFuzzer is missing ('make setup FOR=contributor' installs it)"
fi
builds() {
    clang -std=c11 -D_DEFAULT_SOURCE -Wno-psabi -I. -g -O1 \
        -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -o "$scratch/fuzz" \
        tests/fuzz/scene.c common/scene.c common/nff_*.c common/text.c common/answers.c -lm
}
# New finds go to the scratch folder; the kept corpus is only read.
runs() {
    mkdir "$scratch/new"
    "$scratch/fuzz" -max_total_time="$seconds" -max_len=4096 -dict=tests/fuzz/nff.dict \
        -artifact_prefix="$scratch/" -print_final_stats=1 "$scratch/new" tests/fuzz/corpus \
        2>"$scratch/log" || { tail -n 40 "$scratch/log"; return 1; }
}
check 'the fuzz target builds' builds
check "the scene reader stands $seconds s of fuzzing" runs
sed -n 's/^stat::number_of_executed_units: */+ fuzz: inputs tried: /p' "$scratch/log"
finish fuzz
