// prelude.h - inserted before each attack, after the contract of its exercise (cases.py).
#include "common/answers.h"
#include "common/failed_check.h"

#include <fcntl.h>
#include <setjmp.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

@MESSAGE@
extern char __bss_start[], _end[];

// Searches memory from *at on for a message of the judge.
static inline bool find_call(char **at, MessageHeader *found)
{
    for (; *at + sizeof *found < _end; *at += 8) {
        memcpy(found, *at, sizeof *found);
        if (found->magic == MESSAGE_MAGIC)
            return true;
    }
    return false;
}

// Tells that something forbidden could be done (reports.py).
#define tell_if(could)                   \
    do                                   \
        if (could)                       \
            return vec3_of(7777, 1, 0);  \
    while (0)

static inline void loop_for_ever(void)
{
    for (volatile int i = 0;; i ^= 1)
        ;
}
