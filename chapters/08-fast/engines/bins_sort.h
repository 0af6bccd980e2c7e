// bins_sort.h - sorts the spheres that a light sees into bins (light_grid.c): a counting sort.
#ifndef CHAPTERS_08_FAST_BINS_SORT_H
#define CHAPTERS_08_FAST_BINS_SORT_H

#include "chapters/08-fast/engines/bins_lanes.h"

#include <stdbool.h>

// The visible ones of count places, near ones first; all depths are from nearest to farthest.
// Returns their number; -1 if there is not enough memory.
int places_by_depth(const Place *places, int count, uint32_t nearest, uint32_t farthest,
                    Place *sorted, int threads);

// Bin number b holds the items from start[b] to start[b + 1] - 1.
typedef struct {
    int *items;
    size_t *start;
} Bins;

// Sorts count places into the tiles of the rows top to bottom - 1, with columns tiles in each row.
// The places keep their order. False if there is not enough memory. Free it with bins_free.
bool bins_by_tile(Bins *bins, const Place *places, int count, int columns, int top, int bottom,
                  int threads);
void bins_free(Bins *bins);

#endif
