// parallel.c - a queue: whoever is free takes the next number.
#include "chapters/08-fast/parallel.h"

#include <pthread.h>
#include <stdatomic.h>

enum { MOST_THREADS = 256 };

typedef struct {
    atomic_int next;
    int parts;
    void (*part)(void *given, int i);
    void *given;
} Queue;

static void *take(void *of)
{
    Queue *queue = of;
    for (int i; (i = atomic_fetch_add(&queue->next, 1)) < queue->parts;)
        queue->part(queue->given, i);
    return NULL;
}

void in_parallel(int threads, int parts, void (*part)(void *given, int i), void *given)
{
    Queue queue = {.parts = parts, .part = part, .given = given};
    pthread_t others[MOST_THREADS];
    int started = 0;
    while (started < threads - 1 && started < MOST_THREADS &&
           pthread_create(&others[started], NULL, take, &queue) == 0)
        started++;
    take(&queue);
    for (int i = 0; i < started; i++)
        pthread_join(others[i], NULL);
}
