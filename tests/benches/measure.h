// measure.h - what the two benches and the other ray tracers that they measure share.
#ifndef TESTS_BENCHES_MEASURE_H
#define TESTS_BENCHES_MEASURE_H

#include "chapters/08-fast/engines/engine.h"

#include <stdlib.h>
#include <string.h>

// Seconds, by a peer that measures itself: what another camera could use, and the casting. An
// engine says when its casting begins (Work.built).
typedef struct {
    double build, cast;
    const char *scene_path;
    const char *folder; // where the bench and its peers write
} Measured;

extern Measured measured;

// Other ray tracers, with the same interface. The last one has no name.
extern const Engine peers[];

// Whether a peer is installed; if not, a message that says what is missing.
bool peer_is_here(const Engine *peer, Message *message);

// Embree's are linked only if make finds Embree 3: otherwise they are NULL.
#define IF_LINKED __attribute__((weak))
bool cast_embree_8(const Work *work, Message *message) IF_LINKED;
bool cast_embree_16(const Work *work, Message *message) IF_LINKED;
bool cast_embree_user(const Work *work, Message *message) IF_LINKED;
bool light_embree(const Work *work, Style style, Message *message) IF_LINKED;

enum { MOST_ROUNDS = 101 };

static inline int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// The value that this share of the values is below: 0.5 gives the median, 0 the least. At most
// MOST_ROUNDS values.
static inline double quantile(const double *values, int count, double share)
{
    double sorted[MOST_ROUNDS];
    memcpy(sorted, values, (size_t)count * sizeof *values);
    qsort(sorted, (size_t)count, sizeof *sorted, by_value);
    double at = share * (count - 1);
    int below = (int)at;
    return below + 1 < count ? sorted[below] + (at - below) * (sorted[below + 1] - sorted[below])
                             : sorted[below];
}

#endif
