#!/bin/sh
# seeds.sh - the matrix of every stem with many seeds: marks must not depend on luck.
#
# With each seed the reference and all other right answers pass and are not accused, every mistake
# fails and is named, and a table of the public inputs fails. In the environment:
# SEEDS, how many (50), from FIRST on (1).
# Only reads the tree.
set -u
. tests/house/runner/library.sh
once seeds "the matrix with other seeds"
export BUILD="${BUILD:-build}" scratch
seeds=${SEEDS:-50}
first=${FIRST:-1}

for contract in exercises/*.h; do
    seq "$first" $((first + seeds - 1)) | sed "s|\$| $(basename "$contract" .h)|"
done >"$scratch/runs"

# shellcheck disable=SC2016 # that shell's own arguments
xargs -n 2 -P "$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)" \
    sh -c 'said=$scratch/said-$1-$2
        SEED=$1 "$BUILD/tests/matrix" "$2" >"$said" 2>&1 && tail -n 1 "$said" | grep -q ", 0 failed\$" && exit
        { echo "not ok: SEED=$1 $BUILD/tests/matrix $2"; grep "^not ok" "$said"; tail -n 1 "$said"; } >"$said-failed"' \
    sh <"$scratch/runs"

cat "$scratch"/said-*-failed 2>/dev/null
runs=$(wc -l <"$scratch/runs")
failed=$(find "$scratch" -name 'said-*-failed' | wc -l)
passed=$((runs - failed))
if [ "$runs" -eq 0 ]; then
    echo 'not ok: no exercises'
    failed=1
fi
finish seeds
