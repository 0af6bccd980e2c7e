#!/bin/sh
# engines.sh - rays a second by engine, scene and number of threads: a table, a CSV and plots.
#
# Usage: engines.sh PROGRAM FOLDER SCENE...; in the environment ROUNDS (7), THREADS ('1 2'),
# LONGEST (3): who takes more seconds casts a smaller picture.
set -u
program=$1
folder=$2
shift 2
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
"$program" -r "${ROUNDS:-7}" -l "${LONGEST:-3}" $options -o "$folder/engines.csv" "$@" | tee "$folder/engines.txt" || exit 1
awk -F, -f tests/benches/engines.awk "$folder/engines.csv" >"$folder/engines.md" || exit 1
echo "written: $folder/engines.txt, $folder/engines.csv, and as tables $folder/engines.md"
command -v gnuplot >/dev/null || exit 0
for n in $threads; do
    for theme in light dark; do
        picture=$folder/engines-$n$([ "$theme" = light ] || echo "-$theme").svg
        gnuplot -e "csv = '$folder/engines.csv'; threads = $n; theme = '$theme'" tests/benches/engines.gp >"$picture" &&
            echo "written: $picture"
    done
done
