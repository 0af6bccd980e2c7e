// bins_sort.h - which spheres are in which bin: a counting sort.
#ifndef CHAPTERS_08_FAST_BINS_SORT_H
#define CHAPTERS_08_FAST_BINS_SORT_H

#include "chapters/08-fast/bins_lanes.h"

#include <stdbool.h>

// The visible among so many places, near ones first; the depths of all are from nearest to
// farthest. Returns how many they are; -1 where memory is short.
int places_by_depth(const Place *places, int count, uint32_t nearest, uint32_t farthest,
                    Place *sorted, int threads);

// Bin number b holds the items from start[b] to start[b + 1] - 1.
typedef struct {
    int *items;
    size_t *start;
} Bins;

// Which of so many places are in which tile, of the rows of tiles top to bottom - 1, columns in
// each. They keep their order. False where memory is short. Free it with bins_free.
bool bins_by_tile(Bins *bins, const Place *places, int count, int columns, int top, int bottom,
                  int threads);
void bins_free(Bins *bins);

#endif
