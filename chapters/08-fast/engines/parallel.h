// parallel.h - the same work many times, by several threads.
#ifndef CHAPTERS_08_FAST_PARALLEL_H
#define CHAPTERS_08_FAST_PARALLEL_H

// Calls part(given, i) once for each i from 0 to parts - 1, in any order, by this number of threads
// (POSIX threads: every Unix has them, and only a queue is needed). With 1, it uses the caller's
// thread. If a thread cannot be created, the others do its work.
void in_parallel(int threads, int parts, void (*part)(void *given, int i), void *given);

// Calls step(given). If another thread is in such a call, waits until that has ended.
void one_at_a_time(void (*step)(void *given), void *given);

#endif
