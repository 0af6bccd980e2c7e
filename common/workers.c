// workers.c - who does the parts: the caller, or the threads that a program lends.
#include "common/workers.h"

#include <stddef.h>

static InParallel *workers;
static int thread_count;

void workers_are(InParallel *in_parallel, int threads)
{
    workers = in_parallel;
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
