// parallel.c - a queue: a thread that is free takes the next numbers.
//
// It takes many at first, then fewer, at last one by one (guided self-scheduling: Polychronopoulos
// and Kuck, 1987). So all threads finish at the same time, and each works at its own place
// meanwhile. Neighbours in a picture share cache lines, and two threads that write to one line wait
// for each other.
#define _GNU_SOURCE // for affinity
#include "chapters/08-fast/engines/parallel.h"

#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>

enum { MOST_THREADS = 256, SHARES = 8 };

typedef struct {
    atomic_int next;
    int parts, threads;
    void (*part)(void *given, int i);
    void *given;
} Queue;

// Takes some of the remaining numbers, from first on; 0 if none remain.
static int take_some(Queue *queue, int *first)
{
    int some;
    *first = atomic_load(&queue->next);
    do {
        int left = queue->parts - *first;
        some = left / (SHARES * queue->threads);
        some = some > 0 ? some : left > 0 ? 1 : 0;
    } while (!atomic_compare_exchange_weak(&queue->next, first, *first + some));
    return some;
}

static void *take(void *of)
{
    Queue *queue = of;
    for (int first, some; (some = take_some(queue, &first)) > 0;)
        for (int i = first; i < first + some; i++)
            queue->part(queue->given, i);
    return NULL;
}

// Linux may put a new thread on the processor of the thread that creates it, and let it wait there
// for milliseconds, although another processor is idle. So threads are created for the other
// processors. Returns the number of these; 0 if it is not known.
static int start_elsewhere(pthread_attr_t *how)
{
#ifdef __GLIBC__
    cpu_set_t others;
    const int here = sched_getcpu();
    if (here < 0 || here >= CPU_SETSIZE || sched_getaffinity(0, sizeof others, &others) != 0)
        return 0;
    CPU_CLR((size_t)here, &others);
    const int count = CPU_COUNT(&others);
    if (count > 0 && pthread_attr_setaffinity_np(how, sizeof others, &others) == 0)
        return count;
#else
    (void)how;
#endif
    return 0;
}

void in_parallel(int threads, int parts, void (*part)(void *given, int i), void *given)
{
    if (threads > parts)
        threads = parts > 0 ? parts : 1;
    Queue queue = {.parts = parts, .threads = threads, .part = part, .given = given};
    pthread_t others[MOST_THREADS];
    pthread_attr_t how;
    pthread_attr_init(&how);
    const int elsewhere = threads > 1 ? start_elsewhere(&how) : 0;
    int started = 0;
    while (started < threads - 1 && started < MOST_THREADS &&
           ((started < elsewhere && pthread_create(&others[started], &how, take, &queue) == 0) ||
            pthread_create(&others[started], NULL, take, &queue) == 0))
        started++;
    pthread_attr_destroy(&how);
    take(&queue);
    for (int i = 0; i < started; i++)
        pthread_join(others[i], NULL);
}

void one_at_a_time(void (*step)(void *given), void *given)
{
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&lock);
    step(given);
    pthread_mutex_unlock(&lock);
}
