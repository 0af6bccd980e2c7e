#!/bin/sh
# check_summary.sh - what 'make check' ends with: what was not tested and how it would be, then the sum, alone.
# Only reads the tree.
set -u
. tests/house/runner/library.sh

# A program that says these lines: says_this NAME LINE...
says_this() {
    program=$scratch/$1
    shift
    { echo '#!/bin/sh' && printf "echo '%s'\n" "$@"; } >"$program" && chmod +x "$program"
}
says_this whole 'whole: 3 passed, 0 failed'
says_this part "skipped: a picture: gnuplot is missing (make setup installs it)" 'part: 2 passed, 0 failed'
says_this wrong 'not ok: a sentence' 'wrong: 1 passed, 1 failed'
ends_with() {
    wanted=$1
    shift
    "$BUILD/tests/house/runner/run_tests" "$scratch/log" "$@" >"$scratch/said" 2>&1
    cat "$scratch/said"
    [ "$(tail -n "$(echo "$wanted" | wc -l)" "$scratch/said")" = "$wanted" ]
}
check 'the sum is the last line' ends_with '3 passed, 0 failed' "$scratch/whole"
check 'then nothing is listed as untested' says_not 'Not tested'
check 'the skipped tests are listed just before it' ends_with 'Not tested here:
  a picture: gnuplot is missing (make setup installs it)
6 passed, 1 failed' "$scratch/part" "$scratch/whole" "$scratch/wrong"
says_this many '+ 3 known mistakes' '+ 4 tests' 'a line' 'many: 1 passed, 0 failed'
says_this more '+ 40 known mistakes' '+ seed 7: 12 inputs' 'more: 1 passed, 0 failed'
check 'what is counted is added up' ends_with 'In all: 43 known mistakes, 4 tests
2 passed, 0 failed' "$scratch/many" "$scratch/more"
check 'and other useful lines are shown' says 'seed 7: 12 inputs'
check 'other lines are not' says_not 'a line'

# The seconds of each test are kept: those of a processor, then those by the clock.
# shellcheck disable=SC2016 # the test expands it
printf '#!/bin/sh\ni=0; while [ $i -lt 600000 ]; do i=$((i + 1)); done; echo "busy: 1 passed, 0 failed"\n' >"$scratch/busy"
printf '#!/bin/sh\nsleep 1; echo "idle: 1 passed, 0 failed"\n' >"$scratch/idle"
chmod +x "$scratch/busy" "$scratch/idle"
check 'a busy and an idle test run' ends_with '2 passed, 0 failed' "$scratch/busy" "$scratch/idle"
took() {
    cat "$scratch/log/seconds"
    grep -qE "^$2 [0-9]+ $scratch/$1\$" "$scratch/log/seconds"
}
check 'the idle test took hardly any time of a processor' took idle '0\.0[0-9]'
check 'the busy test took some' took busy '([1-9][0-9]*\.[0-9]+|0\.[1-9][0-9])'

# A test that does not come to its end has failed, whatever it has said.
ends_by() {
    printf '#!/bin/sh\necho "ends: 5 passed, 0 failed"\n%s\n' "$1" >"$scratch/ends" && chmod +x "$scratch/ends"
    "$BUILD/tests/house/runner/run_tests" "$scratch/log" "$scratch/whole" "$scratch/ends" >"$scratch/said" 2>&1
    status=$?
    cat "$scratch/said"
    [ $status -eq 1 ] && [ "$(tail -n 1 "$scratch/said")" = '3 passed, 1 failed' ]
}
check 'a test that exits with 3 has failed' ends_by 'exit 3'
check 'and that is reported' says "$scratch/ends: ended with exit status 3"
check 'so has one that is killed' ends_by 'kill -9 $$'
check 'and that is reported' says "$scratch/ends: ended by signal 9"
check 'so has one whose last line is another' ends_by 'echo "and more"'

# Scripts that may build take turns; those that only read run beside them.
for name in one.sh two.sh three.sh; do
    cat >"$scratch/$name" <<EOF
#!/bin/sh
mkdir "$scratch/turn" && sleep 0.1 && rmdir "$scratch/turn" && echo "$name: 1 passed, 0 failed"
EOF
    chmod +x "$scratch/$name"
done
check 'scripts that may build take turns' ends_with '3 passed, 0 failed' "$scratch/one.sh" "$scratch/two.sh" "$scratch/three.sh"
# Those that build only below their own answers meet: each waits for the other.
for name in one two; do
    printf '#!/bin/sh\n# Builds only below its answers.\n: >"%s/%s-begun"\n' "$scratch" $name >"$scratch/$name.sh"
    cat >>"$scratch/$name.sh" <<EOF
for wait in \$(seq 1200); do
    [ ! -e "$scratch/one-begun" ] || [ ! -e "$scratch/two-begun" ] || break
    sleep 0.1
done
[ "\$wait" -lt 1200 ] && echo "$name: 1 passed, 0 failed"
EOF
done
check 'those that build below their own answers do not' ends_with '2 passed, 0 failed' "$scratch/one.sh" "$scratch/two.sh"

# What took longest begins first the next time. These take turns, so it is seen in which order they begin.
for name in first second third; do
    printf '#!/bin/sh\necho %s >>"%s/order"; echo "%s: 1 passed, 0 failed"\n' $name "$scratch" $name \
        >"$scratch/$name.sh" && chmod +x "$scratch/$name.sh"
done
printf '1.00 1 %s\n9.00 1 %s\n3.00 1 %s\n' "$scratch/first.sh" "$scratch/second.sh" "$scratch/third.sh" >"$scratch/log/seconds"
longest_begins_first() {
    "$BUILD/tests/house/runner/run_tests" "$scratch/log" "$scratch/first.sh" "$scratch/second.sh" "$scratch/third.sh" \
        >"$scratch/said" && [ "$(tr '\n' ' ' <"$scratch/order")" = 'second third first ' ]
}
check 'those that took longest begin first' longest_begins_first

# Told to end, it ends what it has started.
printf '#!/bin/sh\necho $$ >"%s/sleeper"\nsleep 1000 &\nwait\n' "$scratch" >"$scratch/sleeps" && chmod +x "$scratch/sleeps"
start "$BUILD/tests/house/runner/run_tests" "$scratch/log" "$scratch/sleeps" >/dev/null 2>&1
check 'a test runs' wait_until test -s "$scratch/sleeper"
kill "${started##* }"
is_gone() {
    ! kill -0 "$(cat "$scratch/sleeper")"
}
check 'and ends with what runs it' wait_until is_gone
finish check_summary
