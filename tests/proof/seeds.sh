#!/bin/sh
# seeds.sh - the matrix of every stem with many seeds: marks must not depend on luck.
#
# With each seed the reference and all other right answers pass and are not accused, every mistake
# fails and is named, and an answer that knows the public inputs by heart fails. In the environment:
# SEEDS, how many (50), from FIRST on (1). Or seeds.sh SEED: with this one.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
[ $# -gt 0 ] || once seeds "the matrix with other seeds"
export BUILD="${BUILD:-build}" scratch
first=${1:-${FIRST:-1}}
seeds=${SEEDS:-50}
[ $# -eq 0 ] || seeds=1

for contract in exercises/*.h; do
    seq "$first" $((first + seeds - 1)) | sed "s|\$| $(basename "$contract" .h)|"
done >"$scratch/runs"

# shellcheck disable=SC2016 # that shell's own arguments
xargs -n 2 -P "$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)" \
    sh -c 'said=$scratch/said-$1-$2 matrix=$BUILD/tests/matrix public=$BUILD/tables
        mkdir -p "$scratch/$1" && export JUDGE_TABLES="$scratch/$1"
        { SEED=$1 "$BUILD/tests/record" "$2" "$JUDGE_TABLES/$2.table" && "$matrix" "$2" && "$matrix" "$2" --by-heart "$public"; } >"$said" 2>&1 &&
            rm "$JUDGE_TABLES/$2.table" && exit
        { echo "not ok: SEED=$1 $BUILD/tests/record $2, then $matrix"; grep "^not ok" "$said"; tail -n 1 "$said"; } >"$said-failed"' \
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
