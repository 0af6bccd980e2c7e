#!/bin/sh
# engines.sh - rays a second by engine, scene and number of threads: a table, CSV files and plots.
#
# Usage: engines.sh PROGRAM TABLES FOLDER SCENE...; in the environment ROUNDS (7), THREADS ('1 2'),
# SIZE (1920x1080), LONGEST (3): an engine that takes more seconds casts a smaller picture.
set -u
program=$1
tables=$2
folder=$3
shift 3
mkdir -p "$folder"
BENCH_SCRATCH=$(mktemp -d) || exit 1
export BENCH_SCRATCH
trap 'rm -rf "$BENCH_SCRATCH"' EXIT
threads=${THREADS:-1 2}
options=
for n in $threads; do
    options="$options -t $n"
done
# shellcheck disable=SC2086 # options are words
"$program" -r "${ROUNDS:-7}" -l "${LONGEST:-3}" -s "${SIZE:-1920x1080}" $options -o "$folder/rays-per-second.csv" \
    -p "$folder/ratios.csv" "$@" | tee "$folder/engines.txt" || exit 1
"$tables" "$folder" >"$folder/tables.md" || exit 1
echo "written: $folder/engines.txt, $folder/rays-per-second.csv, $folder/ratios.csv, and as tables $folder/tables.md"
command -v gnuplot >/dev/null || exit 0
for n in $threads; do
    "$tables" -f "$n" "$folder" >"$folder/engines-$n.gp" || exit 1
    for theme in light dark; do
        picture=$folder/engines-$n$([ "$theme" = light ] || echo "-$theme").svg
        gnuplot -e "theme = '$theme'" "$folder/engines-$n.gp" tests/benches/engines.gp >"$picture" &&
            echo "written: $picture"
    done
done
