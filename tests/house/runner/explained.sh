# explained.sh - for the tests of what a student reads where an answer does not compile.
#
#     explains SENTENCE STEM SED-COMMAND HELP
#
# The solution of that stem, but for a line that the command breaks.
# shellcheck shell=sh
. tests/house/runner/library.sh

cc=${CC:-cc}
explain=${BUILD:-build}/explain
flags="-std=c11 -D_DEFAULT_SOURCE -ffp-contract=off -Wno-psabi -I. -Wall -Wextra -Wno-unused-parameter
    -Werror=return-type -Werror=implicit-function-declaration"

# The compiler's words are in $scratch/words, what is made of them in $scratch/said.
compile() {
    answer=$scratch/$1.c
    # shellcheck disable=SC2086 # the compiler and its flags are words
    LC_ALL=C $cc $flags -c -o "$scratch/answer.o" "$answer" 2>"$scratch/words"
    "$explain" "$answer" <"$scratch/words" >"$scratch/said" 2>&1
}
# The solution of a stem, but for a line: the sed command.
broken() {
    sed "$2" "solutions/$1.c" >"$scratch/$1.c"
    compile "$1"
}
line_of() {
    grep -n -m 1 -F -- "$1" "$answer" | cut -d : -f 1
}
# Help may be wrapped: it is looked for as one line.
says() {
    cat "$scratch/said"
    tr -s '\n ' '  ' <"$scratch/said" | grep -qF -- "$1"
}
says_not() {
    ! says "$1"
}
helps() {
    says " help: $1"
}
only_their_own() {
    cat "$scratch/said"
    grep -q "^$answer:[0-9]" "$scratch/said" &&
        ! grep -E '^[^ |]+:[0-9]+:' "$scratch/said" | grep -vF "$answer:" &&
        ! grep -E '^In file|^ +from |^cc1|: In function|generated\.$|terminated' "$scratch/said" &&
        ! grep -E '^.{80}| $' "$scratch/said"
}
# One mistake, one message, and that an error.
alone() {
    cat "$scratch/said"
    [ "$(grep -cE "^$answer:[0-9:]+ (fatal )?(error|warning):" "$scratch/said")" -eq 1 ] &&
        grep -qE "^$answer:[0-9:]+ error:" "$scratch/said" && only_their_own
}
# Broken like this, the message has this help and no other.
explains() {
    sentence=$1
    broken "$2" "$3"
    check "$sentence" helps "$4"
    check "$sentence: alone" alone
}
