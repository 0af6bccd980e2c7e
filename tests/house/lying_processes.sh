#!/bin/sh
# lying_processes.sh - answering processes that speak the judge's language, and lie.
#
# Hostile code wrote everything that comes through the pipe: none of it is believed or shown unless
# it can be true.
# Only reads the tree.
set -u
. tests/house/runner/library.sh

folder=$scratch/verdict
mkdir "$folder"

# An answering process that, in the place of an answer, sends a header and bytes after it, so
# changed.
lies() {
    cat >"$scratch/liar.c" <<EOF
#include "tests/judge/answering.h"
#include "tests/judge/wire.h"

#include <string.h>
#include <unistd.h>

int main(void)
{
    static char bytes[1 << 20];
    WireHeader header;
    WireCrash crash = {.signal = 11, .access = 1};
    while (read(CALLS_IN, &header, sizeof header) == sizeof header) {
        for (size_t left = header.size; left > 0;)
            left -= (size_t)read(CALLS_IN, bytes, left);
        header.kind = WIRE_ANSWER;
        header.size = sizeof(vec3);
        memset(bytes, 0, sizeof bytes);
        $1
        if (header.kind == WIRE_CRASH)
            memcpy(bytes, &crash, sizeof crash);
        if (write(ANSWERS_OUT, &header, sizeof header) < 0 ||
            write(ANSWERS_OUT, bytes, header.size) < 0)
            return 1;
    }
    return 0;
}
EOF
    rm -f "$folder"/*
    # shellcheck disable=SC2086 # the compiler's flags are words
    $COMPILER -o "$scratch/liar" "$scratch/liar.c" -lm || return 1
    shift
    env "$@" "$BUILD/judge" 01-corners "$scratch/liar" "$folder" >"$scratch/said" 2>&1
    [ $? -eq 1 ]
}
# The first function, which is upper_left: what the report has of it under a name.
reports() {
    cat "$folder/report"
    sed '1d; /^function/,$d' "$folder/report" | grep -qx "$1	$2"
}
is_no_answer() {
    reports state crashed && reports how 'sent an invalid answer'
}

check 'zeros are judged' lies ''
check 'and are wrong' reports state wrong
check 'a blank may say its name' lies 'strcpy(header.missing, "upper_left");'
check 'and is not answered yet' reports state unanswered

check 'a name that is none is judged' lies 'strcpy(header.missing, "\033[2Jright");'
check 'and is not an answer' is_no_answer
check 'a name and more is judged' lies 'strcpy(header.missing, "upper_left right");'
check 'and is not an answer' is_no_answer
check 'a name without an end is judged' lies 'memset(header.missing, 97, sizeof header.missing);'
check 'and is not an answer' is_no_answer

crash='header.kind = WIRE_CRASH; header.size = sizeof crash;'
check 'a crash is judged' lies "$crash crash.address = 4096;"
check 'and told' reports how 'crashed: write to address 0x1000'
check 'a crash by no signal is judged' lies "$crash crash.signal = 123456789;"
check 'and is not an answer' is_no_answer
check 'a crash by a negative signal is judged' lies "$crash crash.signal = -1;"
check 'and is not an answer' is_no_answer

finish lying_processes
