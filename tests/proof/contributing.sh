#!/bin/sh
# contributing.sh - CONTRIBUTING's examples, step by step in a copy of the tree: each diff of the page is
# applied, and 'make missing' says what the page says that it does.
# Only reads the tree.
set -u
. tests/house/runner/library.sh
once contributing "CONTRIBUTING's examples"

page=$here/.github/CONTRIBUTING.md
tree=$scratch/tree
mkdir "$tree"
git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents -t "$tree" 2>/dev/null
cd "$tree" || exit 1
unset MAKEFLAGS ANSWERS CI # what is missing is a warning then, and no error
# 'make skeletons' writes only over what is committed.
git init -q . && git add -A && git -c user.name=nobody -c user.email=nobody@localhost commit -qm copy || exit 1

# The page, cut at its fences: block-NN begins with the text after ```.
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
check 'the page has both examples' test "$steps" -ge 11

# The new exercise is judged like the others, and each mistake is named.
for stem in 02-cameras 09-plane; do
    check "$stem is tested like the others" make -s build/tests/matrix
    check 'and its mistakes are named' build/tests/matrix "$stem"
done
check 'the blanks are written' make -s skeletons
check 'and ask for it' grep -q '^double aspect_of(Camera c)$' exercises/02-cameras.c
says_not_answered_yet() {
    make -s exercises EX=09 >"$scratch/said" 2>&1
    cat "$scratch/said"
    grep -q 'not answered yet: hit_plane' "$scratch/said"
}
check 'the new chapter is judged' says_not_answered_yet
finish contributing
