// bins_sort.h - which spheres are in which bin: a counting sort.
#ifndef CHAPTERS_08_FAST_BINS_SORT_H
#define CHAPTERS_08_FAST_BINS_SORT_H

#include "chapters/08-fast/bins_lanes.h"

#include <stdbool.h>

// Bin number b holds the items from start[b] to start[b + 1] - 1.
typedef struct {
    int *items;
    size_t *start;
} Bins;

// The visible among so many places, near ones first: one bin, in items. False where memory is
// short. Free it with bins_free.
bool bins_by_depth(Bins *bins, const Place *places, int count, int threads);

// The same into the tiles of some rows of tiles, columns in each; near ones first in each tile.
bool bins_by_tile(Bins *bins, const Place *places, const Bins *by_depth, int columns, int top,
                  int bottom, int threads);

void bins_free(Bins *bins);

#endif
