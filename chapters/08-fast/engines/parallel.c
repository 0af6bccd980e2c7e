// parallel.c - the two ways of doing more at a time: threads, and vectors of the processor.
//
// Threads take numbers from a queue, some at a time, so that each works at its own place meanwhile.
// Neighbours in a picture share cache lines: two threads that write to one wait for each other.
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/lanes.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>

enum { MOST_THREADS = 256, SHARES = 16 };

typedef struct {
    atomic_int next;
    int parts, some;
    void (*part)(void *given, int i);
    void *given;
} Queue;

static void *take_parts(void *given)
{
    Queue *queue = given;
    for (int first; (first = atomic_fetch_add(&queue->next, queue->some)) < queue->parts;)
        for (int i = first; i < first + queue->some && i < queue->parts; i++)
            queue->part(queue->given, i);
    return NULL;
}

void in_parallel(int threads, int parts, void (*part)(void *given, int i), void *given)
{
    if (threads > parts)
        threads = parts > 0 ? parts : 1;
    Queue queue = {
        .parts = parts, .some = parts / (SHARES * threads) + 1, .part = part, .given = given};
    pthread_t others[MOST_THREADS];
    int started = 0;
    while (started < threads - 1 && started < MOST_THREADS &&
           pthread_create(&others[started], NULL, take_parts, &queue) == 0)
        started++;
    take_parts(&queue);
    for (int i = 0; i < started; i++)
        pthread_join(others[i], NULL);
}

// ---- instruction sets -------------------------------------------------------------------------

const char *const lanes_names[LANES_KINDS] = {"baseline", "avx2", "avx512"};

LanesKind lanes_at_most = LANES_AVX512;

// Asks for exactly the instruction sets that the Makefile compiles for.
static LanesKind lanes_of_processor(void)
{
#ifdef __x86_64__
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
        return LANES_BASELINE;
    if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512vl") ||
        !__builtin_cpu_supports("avx512bw") || !__builtin_cpu_supports("avx512dq"))
        return LANES_AVX2;
    return LANES_AVX512;
#else
    return LANES_BASELINE;
#endif
}

LanesKind lanes_best(void)
{
    LanesKind kind = lanes_of_processor();
    return kind < lanes_at_most ? kind : lanes_at_most;
}

void *lanes_memory(size_t size)
{
    const size_t line = 64, page = (size_t)1 << 21, unit = size < page ? line : page;
    if (size > SIZE_MAX - unit)
        return NULL;
    size = (size + unit - 1) / unit * unit;
    void *memory = aligned_alloc(unit, size);
#ifdef MADV_HUGEPAGE
    if (memory != NULL && unit == page)
        madvise(memory, size, MADV_HUGEPAGE);
#endif
    return memory;
}
