// quantile.h - medians and quartiles of what was measured.
#ifndef TESTS_BENCHES_QUANTILE_H
#define TESTS_BENCHES_QUANTILE_H

#include <stdlib.h>
#include <string.h>

enum { MOST_ROUNDS = 101 };

static inline int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// The value that so large a share lies below; 0.5 gives the median, 0 the least. At most
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
