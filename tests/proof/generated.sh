#!/bin/sh
# generated.sh - thousands of wrong answers that nobody wrote by hand: do they fail, and is the verdict on them true?
#
# tests/proof/generated/ makes them from all known answers, with a seed, and judges them by the tables of three seeds.
# This test fails if no test notices a plain slip in a solution, or if a verdict is another one with other random numbers
# (check_verdicts.py), unless tests/proof/generated/reviewed explains the case; and if less than 90% of a chapter's wrong
# answers are named or described.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
once generated "wrong answers that nobody has thought of"
if [ "${BUILD:-build}" != build ]; then
    skip generated "generated: what crashes on purpose needs the ordinary build"
fi
for contract in exercises/*.h; do
    counted python3 -B tests/proof/generated/check_verdicts.py "$(basename "$contract" .h)"
done
finish generated
