#!/bin/sh
# lying_processes.sh - answering processes that speak the judge's language, and lie.
#
# Hostile code wrote everything that comes through the pipe: none of it is believed or shown unless
# it can be true.
# Only reads the tree.
set -u
cd "$(dirname "$0")/../.." && . tests/house/runner/library.sh

folder=$scratch/verdict
mkdir "$folder"

# An answering process that, in the place of an answer, sends a header and bytes after it, so
# changed.
lies() {
    cat >"$scratch/liar.c" <<EOF
#include "tests/judge/process.h"
#include "tests/judge/message.h"

#include <string.h>
#include <unistd.h>

int main(void)
{
    static char bytes[1 << 20];
    MessageHeader header;
    Crash crash = {.signal = 11, .access = 1};
    while (read(CALLS_IN, &header, sizeof header) == sizeof header) {
        for (size_t left = header.size; left > 0;)
            left -= (size_t)read(CALLS_IN, bytes, left);
        header.kind = MESSAGE_ANSWER;
        header.size = 3 * sizeof(double);
        memset(bytes, 0, sizeof bytes);
        $1
        if (header.kind == MESSAGE_CRASH)
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
    "$BUILD/judge" 01-corners "$scratch/liar" "$folder" >"$scratch/said" 2>&1
    [ $? -eq 1 ]
}
# The first function, which is upper_left: what the report has of it.
ends_as() { # STATE C
    lies "$2" && sed '1d; /^function/,$d' "$folder/report" >"$scratch/first" && cat "$scratch/first"
    grep -q "^$1\$" "$scratch/first"
}
no_answer='how	sent an invalid answer'
check 'zeros are wrong' ends_as 'state	wrong' ''
check 'a blank may say its name' ends_as 'state	unanswered' 'strcpy(header.missing, "upper_left");'
check 'a name that is none is not an answer' ends_as "$no_answer" 'strcpy(header.missing, "\033[2Jright");'
check 'nor is an answer to another call' ends_as "$no_answer" 'header.nonce++;'
check 'nor is a name and more' ends_as "$no_answer" 'strcpy(header.missing, "upper_left right");'
check 'nor a name without an end' ends_as "$no_answer" 'memset(header.missing, 97, sizeof header.missing);'
crash='header.kind = MESSAGE_CRASH; header.size = sizeof crash;'
check 'a crash is told' ends_as 'how	crashed: write to address 0x1000' "$crash crash.address = 4096;"
check 'one by no signal is not an answer' ends_as "$no_answer" "$crash crash.signal = 123456789;"
check 'nor is one by a negative signal' ends_as "$no_answer" "$crash crash.signal = -1;"

# CK_RUN_CASE, which chooses the tests of one function for a debugger, changes no verdict.
mkdir "$scratch/all" "$scratch/one"
"$BUILD/judge" 01-corners /bin/false "$scratch/all" >"$scratch/said" 2>&1
CK_RUN_CASE=upper_left "$BUILD/judge" 01-corners /bin/false "$scratch/one" >"$scratch/said" 2>&1
check 'a verdict has every function' cmp "$scratch/all/report" "$scratch/one/report"
finish lying_processes
