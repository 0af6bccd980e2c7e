#!/bin/sh
# habits.sh - the habits of the house that no compiler knows: any C file opens with its name and why
# it is there. Answers in exercises/ and examples of them may be as they are.
# Only reads the tree.
set -u
. tests/house/runner/library.sh

c_files() {
    find chapters common exercises solutions tests -name '*.[ch]' ! -path 'exercises/*.c' \
        ! -path 'tests/grade/*' "$@"
}
no_c_file() {
    c_files -exec awk "$1" '{}' + >"$scratch/found"
    cat "$scratch/found"
    [ ! -s "$scratch/found" ]
}
check 'there are C files' test "$(c_files | wc -l)" -gt 100
# shellcheck disable=SC2016 # awk's own
check 'every C file opens with its name and why it is there' \
    no_c_file 'FNR == 1 { name = FILENAME; sub(/.*\//, "", name) } FNR == 1 && index($0, "// " name " - ") != 1 { print FILENAME ": " $0 }'

# Programs that are ended by their name may be somebody else's, and not every machine has these.
ends_by_name() {
    grep -rnwE --include='*.sh' --include='*.py' 'pkill|killall|pgrep' tests .make | grep -v '^tests/house/habits.sh:'
}
no_program_is_ended_by_its_name() {
    ! ends_by_name
}
check 'no program is ended by its name' no_program_is_ended_by_its_name
# A reader sees each page and each makefile as it is.
no_markers() {
    ! grep -rnE '^(<!--[[~]|<!--\]|#\[|#\]|#~)' Makefile .make README.md chapters exercises tests --include='*.md' --include='*.mk' --include=Makefile
}
check 'no page and no makefile has parts for somebody else' no_markers
check 'README.md has at most 100 lines' test "$(wc -l <README.md)" -le 100
# There are several awks, and what is worth a program is worth one in C.
no_awk() {
    ! grep -rnw awk Makefile .make chapters common exercises solutions tests/course tests/handout tests/judge
}
check 'only tests and measurements use awk' no_awk
# Tests are started as programs.
all_may_be_executed() {
    find tests/house tests/proof -maxdepth 1 -name '*.sh' ! -perm -u+x >"$scratch/found"
    cat "$scratch/found"
    [ ! -s "$scratch/found" ]
}
check 'every script of tests may be executed' all_may_be_executed
finish habits
