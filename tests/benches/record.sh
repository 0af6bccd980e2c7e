#!/bin/sh
# record.sh - the lesson of chapter 08 gets the numbers that were just measured: its CSV files, the
# figure and the tables. 'make bench-record PEERS=1' calls it, on a machine that does nothing else.
#
# Usage: record.sh MEASURED-FOLDER CHAPTER-FOLDER
set -eu
measured=$1
chapter=$2
cp "$measured/engines.csv" "$chapter/figures/rays-per-second.csv"
cp "$measured/shaded.csv" "$chapter/figures/shaded-pictures.csv"
cp "$measured/engines-1.svg" "$chapter/figures/rays-per-second.svg"
cp "$measured/engines-1-dark.svg" "$chapter/figures/rays-per-second-dark.svg"
cat "$measured/engines.md" - "$measured/shaded.md" <<END >"$measured/tables.md"

END
awk -F'|' -f tests/benches/tables.awk "$measured/tables.md" "$chapter/README.md" >"$measured/README.md"
if ! grep -q '^| milliseconds for a shaded picture' "$measured/README.md"; then
    awk 'FNR == NR { table = table $0 "\n"; next }
        /^These numbers are the reason/ {
            print "The same scenes shaded, three mirrors deep, with the time that building takes. In the columns of"
            print "Embree it traces the rays, and the functions of chapter 07 shade, as here. A number below"
            print "\"times\" is how many times as long it takes:\n"
            print table
        }
        { print }' "$measured/shaded.md" "$measured/README.md" >"$measured/with_shaded.md"
    mv "$measured/with_shaded.md" "$measured/README.md"
fi
cp "$measured/README.md" "$chapter/README.md"
git --no-pager diff --stat -- "$chapter" || true
