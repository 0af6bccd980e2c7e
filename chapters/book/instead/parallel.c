// parallel.c - one thread, and memory for lanes: a page has no POSIX threads, but a pool of Workers
// (chapters/book/cast/pool.js).
//
// Stands in for chapters/08-fast/engines/parallel.c.
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/lanes.h"

#include <stdlib.h>

void in_parallel(int threads, int parts, void (*part)(void *given, int i), void *given)
{
    (void)threads;
    for (int i = 0; i < parts; i++)
        part(given, i);
}

void *lanes_memory(size_t size)
{
    const size_t line = 64;
    return aligned_alloc(line, (size + line - 1) / line * line);
}
