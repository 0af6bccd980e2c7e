// workers.c - who does the parts: the caller, or the threads that a program lends.
#include "common/workers.h"

#include <stddef.h>

static InParallel *workers;
static OneAtATime *in_turns;
static int thread_count;

void workers_are(InParallel *in_parallel, OneAtATime *one_at_a_time, int threads)
{
    workers = in_parallel;
    in_turns = one_at_a_time;
    thread_count = threads;
}

int workers_count(void)
{
    return workers != NULL && thread_count > 1 ? thread_count : 1;
}

void workers_do(int parts, void (*part)(void *given, int i), void *given)
{
    if (workers_count() > 1 && parts > 1) {
        workers(thread_count, parts, part, given);
        return;
    }
    for (int i = 0; i < parts; i++)
        part(given, i);
}

void workers_one_at_a_time(void (*step)(void *given), void *given)
{
    if (workers_count() > 1)
        in_turns(step, given);
    else
        step(given);
}
