#!/bin/sh
# seeds.sh - the effect of SEED: other inputs for each, the same for the same, and none is shown (seeds.txt).
# Builds only below its answers.
. tests/house/runner/library.sh

# Marks do not depend on it. (In check-all that test runs by itself, with more seeds.)
[ -n "${LONG:-}" ] || check 'with other seeds right answers pass and mistakes are named' \
    env SEEDS=1 FIRST=4711 tests/proof/seeds.sh
once seeds "what a seed does to a report"
counted python3 -B tests/house/runner/transcript.py tests/house/seeds.txt
finish seeds
