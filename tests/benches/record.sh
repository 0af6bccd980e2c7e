#!/bin/sh
# record.sh - the lesson of chapter 08 gets the numbers that were just measured: its CSV files, the
# figure and the tables. 'make bench-record PEERS=1' calls it, on a machine that does nothing else.
#
# Usage: record.sh TABLES MEASURED-FOLDER CHAPTER-FOLDER
set -eu
tables=$1
measured=$2
chapter=$3
"$tables" "$measured" "$chapter/README.md" >"$measured/README.md"
cp "$measured/README.md" "$chapter/README.md"
for csv in rays-per-second ratios shaded-pictures; do
    cp "$measured/$csv.csv" "$chapter/figures/$csv.csv"
done
cp "$measured/engines-1.svg" "$chapter/figures/rays-per-second.svg"
cp "$measured/engines-1-dark.svg" "$chapter/figures/rays-per-second-dark.svg"
git --no-pager diff --stat -- "$chapter" || true
