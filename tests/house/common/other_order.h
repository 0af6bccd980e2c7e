// other_order.h - workers for tests: all parts, the last one first. Nothing may depend on the
// order.
#ifndef TESTS_COMMON_OTHER_ORDER_H
#define TESTS_COMMON_OTHER_ORDER_H

#include "common/workers.h"

static int most_parts; // that were done together

static inline void last_part_first(int threads, int parts, void (*part)(void *given, int i),
                                   void *given)
{
    (void)threads;
    most_parts = parts > most_parts ? parts : most_parts;
    for (int i = parts - 1; i >= 0; i--)
        part(given, i);
}

static inline void at_once(void (*step)(void *given), void *given)
{
    step(given);
}

#endif
