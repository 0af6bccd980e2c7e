#!/bin/sh
# grade.sh - tests of the grader. grade.sh PART: 'class' (or nothing) marks a small class, and the ten submissions of the
# instructor's page; 'modules': what is a submission, what it is worth, what is written of a graded class, and what 'make
# submission' packs; 'long': a grader that is killed, shared, and started again gives the same marks, and a failure of the
# machine is never a mark; archives that grow when they are opened; the archive for Gradescope, built, installed, given
# submissions; 'attacks': a few that change nothing where they succeed, on the tree as it is; 'attacks all': all of them,
# on a tree full of secrets and in every sandbox that there is.
# Only reads the tree.
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh
part=${1:-class}
once grading "grading, $part"
[ "$part" = modules ] || [ -n "$KIT" ] ||
    skip grading "grading, $part: it needs libseccomp and ld ('make setup FOR=instructor' installs them), and no sanitizers"
needs grading "grading, $part" python3
case $part in
class) set -- test_grade test_example ;;
modules) set -- test_submissions test_folders test_archives test_policy test_marking test_pack test_reports test_class \
    test_ledger test_return test_similar test_term ;;
long) set -- test_regrade test_faults test_bombs test_gradescope ;;
attacks)
    [ "${2:-}" = all ] || set -- bubblewrap exit-in-constructor exit-in-function forged-answer-early include-what-is-there \
        incbin-reference circle-of-two wait-for-blanks wait-object lend-no- reference- table time-of-day honest-counting \
        honest-latin honest-output honest-pragma honest-printf honest-sorting
    if [ "$1" = attacks ]; then python3 -B tests/grade/attacks; else HERE=1 python3 -B tests/grade/attacks "$@"; fi
    exit
    ;;
esac
python3 -B tests/grade/check "grading, $part" "$@"
