#!/bin/sh
# generated.sh - thousands of wrong answers that nobody wrote by hand: do they fail, and is the verdict on them true?
#
# tests/proof/generated/ makes them from all known answers, with a seed, runs the tests on them, and checks the
# verdicts. This test fails if a wrong answer passes, a right one fails or a mistake is named falsely, unless
# tests/proof/generated/reviewed explains the case; and if less than 90% of a chapter's wrong answers are named or
# described. Only reads the tree.
set -u
. tests/house/runner/library.sh
once generated "wrong answers that nobody has thought of"
if [ "${BUILD:-build}" != build ]; then
    skip generated "generated: what crashes on purpose needs the ordinary build"
fi
seed=${GENERATED_SEED:-2015}
for contract in exercises/*.h; do
    build/tests/try_generated "$(basename "$contract" .h)" "$seed" tests/proof/generated/reviewed >"$scratch/said"
    sed '$d' "$scratch/said" | grep -E '^not ok| tried: |^  (right|wrong|named)'
    counts=$(sed -n '$s/.*: \([0-9]*\) passed, \([0-9]*\) failed$/\1 \2/p' "$scratch/said")
    counts=${counts:-0 1}
    passed=$((passed + ${counts% *}))
    failed=$((failed + ${counts#* }))
    cat "$scratch/said" >>"$scratch/all"
done
awk -v seed="$seed" '
    / tried: / && $1 ~ /^[0-9]/ {
        tried += $2; right += $4; right_failed += substr($6, 2); wrong += $14; failed += $16
        named += $18; falsely += substr($20, 2); described += $22
    }
    END {
        printf "+ seed %s: %d inputs tried, %d right (%d of them failed), %d wrong, %d failed, %d named " \
            "(%d falsely), %d described, %.1f%% named or described\n", seed, tried, right,
            right_failed, wrong, failed, named, falsely, described, 100 * (named + described) / failed
    }' "$scratch/all"
finish generated
