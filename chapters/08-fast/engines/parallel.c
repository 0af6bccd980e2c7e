// parallel.c - a queue: a thread that is free takes the next numbers.
//
// It takes many at first, then fewer, at last one by one (guided self-scheduling: Polychronopoulos
// and Kuck, 1987). So all threads finish at the same time, and each works at its own place
// meanwhile. Neighbours in a picture share cache lines, and two threads that write to one line wait
// for each other.
#include "chapters/08-fast/engines/parallel.h"

#include <pthread.h>
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

void in_parallel(int threads, int parts, void (*part)(void *given, int i), void *given)
{
    if (threads > parts)
        threads = parts > 0 ? parts : 1;
    Queue queue = {.parts = parts, .threads = threads, .part = part, .given = given};
    pthread_t others[MOST_THREADS];
    int started = 0;
    while (started < threads - 1 && started < MOST_THREADS &&
           pthread_create(&others[started], NULL, take, &queue) == 0)
        started++;
    take(&queue);
    for (int i = 0; i < started; i++)
        pthread_join(others[i], NULL);
}
