#!/bin/sh
# blanks.sh - in a handout: blanks pass no test, and an answer that does not compile does not stop the others.
set -u
. tests/house/runner/library.sh

answers=build/blanks
judge() {
    rm -rf "build/$answers"
    make --no-print-directory -s exercises ANSWERS="$answers" >"$scratch/said" 2>&1
}
passes_nothing() {
    record=build/$answers/verdict/$1.record
    cat "$record"
    grep -q '^function' "$record" && ! grep -q '^state[[:space:]]right$' "$record"
}

check 'blanks are not wrong, only not yet' judge
for contract in exercises/*.h; do
    stem=$(basename "$contract" .h)
    check "the blank of $stem passes no test" passes_nothing "$stem"
done
says() {
    cat "$scratch/said"
    grep -qF -- "$1" "$scratch/said"
}
check 'the first blank is the first thing to do' says 'is not answered yet'

answers=$scratch/answers
mkdir "$answers"
cp build/blanks/*.c "$answers"
echo 'this is no C' >"$answers/03-screen.c"
refused() {
    ! make --no-print-directory -s status ANSWERS="$answers" >"$scratch/said" 2>&1
}
check 'what does not compile is not right' refused
judge
check 'and said to be so' says '03-screen        does not compile'
check 'the others are judged' says '04-pixel-ray     not yet'
rm -rf "${answers:?}" "build/$answers"

finish blanks
