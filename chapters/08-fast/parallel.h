// parallel.h - the same work many times, by several threads.
#ifndef CHAPTERS_08_FAST_PARALLEL_H
#define CHAPTERS_08_FAST_PARALLEL_H

// Calls part(given, i) for each i from 0 to parts - 1, each once, in no order, by so many threads
// (POSIX threads: every Unix has them, and a queue is all that is needed). With 1, in this one.
// Where a thread cannot be had, the others do its work.
void in_parallel(int threads, int parts, void (*part)(void *given, int i), void *given);

#endif
