// workers.h - work whose parts do not depend on each other: by the caller, or by several threads.
//
// The files of common have no threads, because most programs do not need any. A program that has
// threads lends them: then long scenes are read, and pictures are written, by all of them.
#ifndef COMMON_WORKERS_H
#define COMMON_WORKERS_H

// Calls part(given, i) once for each i from 0 to parts - 1, in any order, by this many threads.
typedef void InParallel(int threads, int parts, void (*part)(void *given, int i), void *given);

// Calls step(given). If another thread is in such a call, waits until that has ended.
typedef void OneAtATime(void (*step)(void *given), void *given);

// From now on, workers_do and workers_one_at_a_time use these functions, with this number of
// threads. Both NULL: the caller does all parts, in their order.
void workers_are(InParallel *in_parallel, OneAtATime *one_at_a_time, int threads);

// How many threads workers_do uses.
int workers_count(void);

void workers_do(int parts, void (*part)(void *given, int i), void *given);

// For the parts of workers_do.
void workers_one_at_a_time(void (*step)(void *given), void *given);

#endif
