#!/bin/sh
# contributing.sh - CONTRIBUTING's examples, step by step in a copy of the tree: each diff of the page is
# applied, and 'make missing' says what the page says that it does.
# Only reads the tree.
set -u
. tests/library.sh
once contributing "CONTRIBUTING's examples"

page=$here/.github/CONTRIBUTING.md
tree=$scratch/tree
mkdir "$tree"
git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents -t "$tree" 2>/dev/null
cd "$tree" || exit 1
unset MAKEFLAGS ANSWERS
# 'make skeletons' writes only over what is committed.
git init -q . && git add -A && git -c user.name=nobody -c user.email=nobody@localhost commit -qm copy || exit 1

# The page, cut at its fences: block-NN begins with what stands behind ```.
csplit -s -n 3 -f "$scratch/block-" "$page" '/^ *```/' '{*}'
steps=0
for block in "$scratch"/block-*; do
    case $(head -n 1 "$block") in
    '```diff')
        sed 1d "$block" >"$scratch/step.diff"
        file=$(sed -n 's,^+++ b/,,p' "$scratch/step.diff" | head -n 1)
        stem=$(echo "$file" | grep -oE '[0-9]{2}-[a-z-]+' || echo "${stem:-02-cameras}")
        check "the diff of $file fits the tree" git apply "$scratch/step.diff"
        ;;
    '```text')
        sed 1d "$block" >"$scratch/wanted"
        grep -qE '^Next: |lacks anything' "$scratch/wanted" || continue
        says_next() {
            make -s missing EX="${stem%%-*}" >"$scratch/said" 2>"$scratch/errors"
            cat "$scratch/said" "$scratch/errors"
            tail -n 1 "$scratch/said" | diff "$scratch/wanted" -
        }
        check "then make says: $(cat "$scratch/wanted")" says_next
        steps=$((steps + 1))
        ;;
    esac
done
check 'the page has both examples' test "$steps" -ge 5

# What was added is judged, and can be graded.
check 'the new function is tested like the others' make -s build/tests/matrix/02-cameras
check 'and its mistake is named' build/tests/matrix/02-cameras
check 'the blank is written' make -s skeletons
check 'and asks for it' grep -q '^double aspect_of(Camera c)$' exercises/02-cameras.c
finish contributing
