#!/bin/sh
# record.sh - writes what people see into FOLDER: the verdict on every known mistake, the figures and
# pictures, the handout's list of files, and the reports of the example class.
#
# Two versions of the tree that should look the same to everybody are compared by it: a record of
# each, then 'diff -r'. Usage: sh tests/proof/by_hand/record.sh FOLDER (after 'make all check')
set -eu
folder=$1
mkdir -p "$folder/mistakes" "$folder/figures" "$folder/pictures"
for contract in exercises/*.h; do
    build/judge "$(basename "$contract" .h)" --mistakes "$folder/mistakes"
done
cp build/solutions/figures/*/*.svg "$folder/figures"
cp build/solutions/gallery/*.png "$folder/pictures"
make -s --no-print-directory handout
tar tzf build/handout.tar.gz | sed 's,^[^/]*/,,' | sort >"$folder/handout"
make -s --no-print-directory grade SUBMISSIONS=tests/grade/example/class POLICY=tests/grade/example/policy \
    OUT="$folder/class" SEED=2015 2>/dev/null | sed '/^Took/d' >"$folder/grade"
# When and where it was done is not the same twice.
rm -rf "$folder"/class/.[a-z]*
