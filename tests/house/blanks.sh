#!/bin/sh
# blanks.sh - blanks pass nothing; the scripts that write them lose nothing.
# Builds only below its answers.
set -u
. tests/house/runner/library.sh

passes_nothing() {
    "$BUILD/tests/blanks" "$1" >"$scratch/blank" 2>&1
    cat "$scratch/blank"
    grep -q "^$1: 0 passed, [1-9][0-9]* failed\$" "$scratch/blank"
}

for solution in solutions/*.c; do
    stem=$(basename "$solution" .c)
    check "the blank of $stem passes no test" passes_nothing "$stem"
done

# A blank contains its own lines, and nothing of the answer.
cat >"$scratch/solution.c" <<'EOF'
double f(void)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(double);
    return 42;
    // END SOLUTION
}

// BEGIN SOLUTION
static int helper;
// END SOLUTION

int after;
EOF
"$BUILD/tests/handout/make_blank" "$scratch/solution.c" >"$scratch/made"
cat >"$scratch/wanted" <<'EOF'
double f(void)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(double);
    // END SOLUTION
}

int after;
EOF
check 'a blank keeps the markers and the stub, and drops the answer' \
    diff "$scratch/wanted" "$scratch/made"
refused() {
    ! "$@"
}
echo '// BEGIN SOLUTION' >"$scratch/open.c"
echo '// END SOLUTION' >"$scratch/closed.c"
check 'a solution without END SOLUTION is refused' refused "$BUILD/tests/handout/make_blank" "$scratch/open.c"
check 'so is END SOLUTION alone' refused "$BUILD/tests/handout/make_blank" "$scratch/closed.c"

# reset: every answer that was there is still there.
answers=$scratch/answers
mkdir "$answers"
answer=$answers/01-corners.c
resets() {
    make --no-print-directory reset EX=01 ANSWERS="$answers"
}
echo first >"$answer"
check 'reset works' resets
check 'reset restores the blank' cmp build/blanks/01-corners.c "$answer"
check 'reset keeps the answer' grep -qx first "$answer.backup-1"
echo second >"$answer"
check 'reset works again' resets
check 'a second reset keeps the second answer' grep -qx second "$answer.backup-2"
check 'a second reset leaves the first backup' grep -qx first "$answer.backup-1"
check 'a blank can be reset' resets
check 'resetting a blank makes no backup' test ! -e "$answer.backup-3"
rm -rf "build$answers"
cp solutions/01-corners.c "$scratch/solution.c"
spares_solutions() {
    ! make --no-print-directory reset EX=01 ANSWERS=solutions && cmp solutions/01-corners.c "$scratch/solution.c"
}
check 'a solution is not reset' spares_solutions

# skeletons: over what is committed, never over what somebody changed.
tree=$scratch/tree
mkdir -p "$tree/exercises" "$tree/new"
cp -r .make solutions "$tree"
cd "$tree" || exit 1
echo old >exercises/01-a.c
echo old >exercises/02-b.c
git init -q . && git add . && git -c user.name=t -c user.email=t@t commit -qm t
echo mine >exercises/02-b.c
echo new >new/01-a.c
echo new >new/02-b.c
check 'skeletons refuses over a changed file' refused solutions/write_blanks new/01-a.c new/02-b.c
check 'skeletons leaves a changed file as it is' grep -qx mine exercises/02-b.c
check 'skeletons writes over an unchanged file' grep -qx new exercises/01-a.c
rm -rf .git
echo newer >new/01-a.c
check 'without git, skeletons refuses over any other file' refused solutions/write_blanks new/01-a.c
cd "$here" || exit 1

finish blanks
