#!/bin/sh
# grade.sh - how many submissions a minute make grade marks, and what each step takes of them.
#
# In the environment: KIT from the Makefile; COUNT of submissions of six files (tests/benches/class.py).
set -eu
count=${COUNT:-200}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -B tests/benches/class.py "$folder/class" "$count"
before=$(date +%s%N)
python3 -B tests/grade "$KIT" "$folder/class" --out "$folder/out" >"$folder/said" 2>&1 ||
    { cat "$folder/said"; exit 1; }
after=$(date +%s%N)
COUNT=$count NANOSECONDS=$((after - before)) python3 -B - "$folder"/out/*/results.json <<'PY'
import json
import os
import sys

records = [json.load(open(path))["extra_data"]["record"] for path in sys.argv[1:]]
seconds = int(os.environ["NANOSECONDS"]) / 1e9
files = sum(stem["file"] != "" for record in records for stem in record["stems"])
print(f"{len(records)} submissions, {files} files, {seconds:.1f} s on {len(os.sched_getaffinity(0))} processors, "
      f"sandbox: {records[0]['sandbox']}")
print(f"  {60 * len(records) / seconds:.0f} submissions a minute")
each = {step: sum(record["steps"][step] for record in records) / len(records) for step in records[0]["steps"]}
whole = sum(record["seconds"] for record in records) / len(records)
each["the rest"] = whole - sum(each.values())
for step, mean in each.items():
    print(f"  {step:9} {1000 * mean:6.1f} ms of each")
PY
