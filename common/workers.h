// workers.h - work whose parts do not depend on each other: by the caller, or by several threads.
//
// The files of common have no threads, because most programs do not need any. A program that has
// threads lends them: then long scenes are read, and pictures are written, by all of them.
#ifndef COMMON_WORKERS_H
#define COMMON_WORKERS_H

// Calls part(given, i) once for each i from 0 to parts - 1, in any order, by this many threads.
typedef void InParallel(int threads, int parts, void (*part)(void *given, int i), void *given);

// From now on, workers_do uses this function with this number of threads. NULL: the caller does
// all parts, in their order.
void workers_are(InParallel *in_parallel, int threads);

// How many threads workers_do uses.
int workers_count(void);

void workers_do(int parts, void (*part)(void *given, int i), void *given);

#endif
