#!/bin/sh
# shaded.sh - shadows and mirrors: chapter 08 beside its peers, on all scenes: a table and a CSV.
#
# Usage: shaded.sh PROGRAM TABLES FOLDER SCENE...; in the environment ROUNDS (5), THREADS ('1 2'),
# SAMPLES ('1 2' in each direction), SIZE (1920x1080), LONGEST (3): a renderer that takes more seconds
# has fewer rounds.
set -u
program=$1
tables=$2
folder=$3
shift 3
mkdir -p "$folder"
BENCH_SCRATCH=$(mktemp -d) || exit 1
export BENCH_SCRATCH
trap 'rm -rf "$BENCH_SCRATCH"' EXIT
options=
for n in ${THREADS:-1 2}; do
    options="$options -t $n"
done
for n in ${SAMPLES:-1 2}; do
    options="$options -n $n"
done
# shellcheck disable=SC2086 # options are words
"$program" -r "${ROUNDS:-5}" -l "${LONGEST:-3}" -s "${SIZE:-1920x1080}" $options -o "$folder/shaded-pictures.csv" "$@" | tee "$folder/shaded.txt" || exit 1
"$tables" "$folder" >"$folder/tables.md" || exit 1
echo "written: $folder/shaded.txt, $folder/shaded-pictures.csv, and as a table $folder/tables.md"
