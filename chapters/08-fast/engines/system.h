// system.h - what the engines ask of the operating system: the time, and large memory.
#ifndef CHAPTERS_08_FAST_ENGINES_SYSTEM_H
#define CHAPTERS_08_FAST_ENGINES_SYSTEM_H

#include <stddef.h>
#include <time.h>

// For measuring: seconds since some fixed moment.
static inline double clock_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

// Memory for large arrays, in large pages if the system has them. Like malloc; free it with free.
// The memory begins at the start of a cache line. The system finds and clears each page of memory
// at its first use, and that is much cheaper with pages of 2 MB than of 4 KB.
void *large_memory(size_t size);

#endif
