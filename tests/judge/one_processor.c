// one_processor.c - two processes that take turns stay on one processor.
#define _GNU_SOURCE
#include "tests/judge/one_processor.h"

#ifdef __linux__
#include <sched.h>
#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

static cpu_set_t all_processors;
static bool is_on_one;

void stay_on_one_processor(void)
{
    cpu_set_t one;
    int here = sched_getcpu();
    if (is_on_one || here < 0 || here >= CPU_SETSIZE ||
        sched_getaffinity(0, sizeof all_processors, &all_processors) != 0)
        return;
    CPU_ZERO(&one);
    CPU_SET((size_t)here, &one);
    is_on_one = sched_setaffinity(0, sizeof one, &one) == 0;
}

void use_all_processors(int other)
{
    if (!is_on_one)
        return;
    is_on_one = false;
    sched_setaffinity(0, sizeof all_processors, &all_processors);
    sched_setaffinity((pid_t)other, sizeof all_processors, &all_processors);
}
#else
void stay_on_one_processor(void)
{
}

void use_all_processors(int other)
{
    (void)other;
}
#endif
