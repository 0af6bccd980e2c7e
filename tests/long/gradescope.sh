#!/bin/sh
# gradescope.sh - the archive for Gradescope, in a folder that is laid out as it is there.
set -u
. tests/library.sh
once gradescope "the autograder's archive"
needs_grading gradescope 'Gradescope'
# What make exports to this would decide how the copy is built.
unset MAKEFLAGS CC ANSWERS SEED OUT POLICY UNSAFE SANDBOX
AUTOGRADER=$scratch/autograder
export AUTOGRADER
class=tests/grade/example/class

same_twice() {
    # Dates in an archive are even seconds.
    make gradescope && cp build/gradescope.zip "$scratch/first.zip" && sleep 2 &&
        make gradescope && cmp build/gradescope.zip "$scratch/first.zip"
}
check 'the same tree makes the same archive' same_twice

# As unzip does it, with the permissions.
unpacked() {
    python3 - build/gradescope.zip "$AUTOGRADER/source" <<'PYTHON'
import os, sys, zipfile
with zipfile.ZipFile(sys.argv[1]) as archive:
    for info in archive.infolist():
        os.chmod(archive.extract(info, sys.argv[2]), info.external_attr >> 16)
PYTHON
    [ -x "$AUTOGRADER/source/setup.sh" ] && [ -x "$AUTOGRADER/source/run_autograder" ]
}
check 'setup.sh and run_autograder stand at its root' unpacked
check 'setup.sh builds all that grading needs' "$AUTOGRADER/source/setup.sh"

# Where Gradescope copies it.
cp "$AUTOGRADER/source/run_autograder" "$AUTOGRADER/run_autograder"

# What results.json says after a submission has been handed in: score, largest score, first words.
says() {
    wanted=$1
    (cd "$AUTOGRADER" && ./run_autograder) >"$scratch/log" 2>&1
    found=$(python3 - "$AUTOGRADER/results/results.json" <<'PYTHON'
import json, sys
results = json.load(open(sys.argv[1]))
print(f"{results['score']:g} of {sum(test['max_score'] for test in results.get('tests', [])):g}",
      results["output"].split("\n")[0])
PYTHON
    )
    rm -f "$AUTOGRADER/results/results.json"
    echo "says $found"
    tail -n 5 "$scratch/log"
    # shellcheck disable=SC2254 # a pattern, on purpose
    case $found in
    $wanted) ;;
    *) return 1 ;;
    esac
}
hand_in() {
    rm -rf "$AUTOGRADER/submission"
    mkdir "$AUTOGRADER/submission"
    cp -R "$@" "$AUTOGRADER/submission"
}

hand_in $class/another-way/*.c
check 'what is right has its marks' says '24 of 100 graded*'
hand_in $class/does-not-compile/*.c
check 'what does not compile says so' says '9 of 100 does not compile*'
hand_in solutions exercises Makefile tests/exercises.def
cp $class/half-size/03-screen.c "$AUTOGRADER/submission/exercises/"
check 'of a whole toolkit, exercises/ is graded' says '6 of 100 graded*'
hand_in $class/blank
ln -s "$AUTOGRADER/source/toolkit/solutions" "$AUTOGRADER/submission/exercises"
touch "$AUTOGRADER/submission/Makefile"
check 'a link to the solutions is not followed' says '0 of 100 graded*'
rm -rf "$AUTOGRADER/submission"
check 'no submission has a result, too' says '0 of 100 empty*'
hand_in $class/another-way/*.c
SANDBOX=none
export SANDBOX
check 'without a sandbox nothing is graded, and it says why' says '0 of 0 Nothing was graded*'
unset SANDBOX
mv "$AUTOGRADER/source/toolkit/Makefile" "$AUTOGRADER/source/toolkit/gone"
check 'a grader that is broken leaves a result' says '0 of 0 The autograder did not*'
mv "$AUTOGRADER/source/toolkit" "$AUTOGRADER/source/gone"
check 'so does one that is gone' says '0 of 0 The autograder did not*'

finish gradescope
