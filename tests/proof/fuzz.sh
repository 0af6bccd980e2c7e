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
# Scenes that are difficult to read, one a line: a name, and the text as printf's %b takes it.
sed "s/VIEW/v\\\\nfrom 0 0 5\\\\nat 0 0 0\\\\nup 0 1 0\\\\nangle 45\\\\nresolution 8 6\\\\n/
    s/BLANKS/$(printf '%1000s' '')/" <<'SCENES' | while read -r name text; do printf '%b' "$text" >"$scratch/scenes/$name.nff"; done
angle-180 v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 180\nresolution 8 6\n
byte-order-mark \0357\0273\0277VIEW
comments # a comment\n\nVIEWs 0 0 0 1 # another\n#s 0 0 0 1\n#
cone VIEWc\n0 0 0 1\n0 1 0 0\ns 0 0 0 1\n
control-characters \0033[2Jsphere\n
crlf v\r\nfrom 0 0 5\r\nat 0 0 0\r\nup 0 1 0\r\nangle 45\r\nresolution 8 6\r\ns 0 0 0 1\r\n\r\n
empty
everything b 0.1 0.2 0.3\nVIEWhither 1\nl 1 2 3\nl 3 2 1 1 0.5 0\nf 1 0 0 0.8 0.2 10 0 1\ns 0 0 0 1\nf 0 1 0 1 0 0 0 1\ns 1 0 0 .5\ns 0 1 0 .5\n
huge-polygon VIEWp 2147483647\n0 0 0\n
huge-resolution v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nresolution 1000000000 1000000000\n
long-line #BLANKS\n
many-words v 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17\n
minimal VIEW
negative-radius VIEWs 0 0 0 -1\n
no-last-newline VIEWs 0 0 0 1
not-finite VIEWs nan inf 0x1 1e999\n
odd-numbers VIEWs -.5 +5. 1e-3 1E2\ns 1e-999 -0 00 1e-320\n
outside-viewpoint from 0 0 5\n
polygon VIEWp 3\n0 0 0\n1 0 0\n1 1 0\npp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n
second-viewpoint VIEWv\n
swallowing-polygon VIEWp 4\n0 0 0\n1 0 0\n1 1 0\ns 0 0 0 1\n
tabs \tv \nfrom\t0  0\t5\n at 0 0 0\nup 0 1 0\nangle 45\nresolution 8 6\n \t \n
truncated-cone VIEWc\n0 0 0 1\n
truncated-polygon VIEWp 4\n0 0 0\n1 0 0\n
truncated v\nfrom 0 0 5\nat 0 0
zero-byte VIEWs 0 0 0 1\0000\n
SCENES
check "the scene reader survives $seconds s of fuzzing" runs SCENES "$scratch/scenes" common/scene.c
# One case for each recorded text.
mkdir "$scratch/cases"
csplit -s -z -n 3 -f "$scratch/cases/" tests/explain/cases.txt '/^== /' '{*}'
check 'the fuzz target of the explainer builds' \
    builds COMPILERS tests/explain/[!m]*.c
check "the explainer survives $seconds s of fuzzing" runs COMPILERS "$scratch/cases" tests/explain/*.c
cat "$scratch/tried"
finish fuzz
