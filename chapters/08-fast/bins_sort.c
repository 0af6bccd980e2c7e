// bins_sort.c - a counting sort: count what goes into each bin, add up where each begins, fill.
//
// Every thread has a share of the items and counts by itself. Where bin b begins for share p is then
// known beforehand: behind what all shares have in earlier bins, and earlier shares in this one. So
// all fill at the same time, without asking each other, and items stay in order.
#include "chapters/08-fast/bins_sort.h"

#include "chapters/08-fast/parallel.h"

#include <stdlib.h>
#include <string.h>

enum { FEW = 10000 }; // not worth a second thread

typedef struct {
    const Place *places;
    const int *order; // NULL: as they are
    int count;
    bool by_depth;
    uint32_t nearest;         // by depth: of all
    int columns, top, bottom; // by tile
    int bin_count, shares;
    size_t *counts; // of each share, bin after bin; then where it fills
    int *items;
} Sort;

static uint32_t depth_of(Place place)
{
    uint32_t bits;
    memcpy(&bits, &place.near, sizeof bits); // floats that are not negative sort as their bits do
    return bits >> PLACE_DROPPED;
}

// The bins of a place: some columns of some rows.
static inline Part bins_of(const Sort *sort, Place place)
{
    if (place.left >= place.right || place.top >= place.bottom)
        return (Part){0};
    if (sort->by_depth) {
        int bin = (int)(depth_of(place) - sort->nearest);
        return (Part){bin, bin + 1, 0, 1};
    }
    int top = place.top / TILE_HEIGHT, bottom = (place.bottom - 1) / TILE_HEIGHT + 1;
    return (Part){place.left / TILE_WIDTH, (place.right - 1) / TILE_WIDTH + 1,
                  (top > sort->top ? top : sort->top) - sort->top,
                  (bottom < sort->bottom ? bottom : sort->bottom) - sort->top};
}

static int share_begins(const Sort *sort, int share)
{
    return (int)((long long)sort->count * share / sort->shares);
}

static void count_share(void *given, int share)
{
    const Sort *sort = given;
    size_t *counts = sort->counts + (size_t)share * (size_t)sort->bin_count;
    for (int i = share_begins(sort, share); i < share_begins(sort, share + 1); i++) {
        Part bins = bins_of(sort, sort->places[sort->order ? sort->order[i] : i]);
        for (int row = bins.top; row < bins.bottom; row++)
            for (int column = bins.left; column < bins.right; column++)
                counts[row * sort->columns + column]++;
    }
}

static void fill_share(void *given, int share)
{
    const Sort *sort = given;
    size_t *next = sort->counts + (size_t)share * (size_t)sort->bin_count;
    for (int i = share_begins(sort, share); i < share_begins(sort, share + 1); i++) {
        int item = sort->order ? sort->order[i] : i;
        Part bins = bins_of(sort, sort->places[item]);
        for (int row = bins.top; row < bins.bottom; row++)
            for (int column = bins.left; column < bins.right; column++)
                sort->items[next[row * sort->columns + column]++] = item;
    }
}

static size_t add_up(Sort *sort, size_t *start)
{
    size_t sum = 0;
    for (int bin = 0; bin < sort->bin_count; bin++) {
        start[bin] = sum;
        for (int share = 0; share < sort->shares; share++) {
            size_t *count = &sort->counts[(size_t)share * (size_t)sort->bin_count + (size_t)bin];
            size_t here = *count;
            *count = sum;
            sum += here;
        }
    }
    start[sort->bin_count] = sum;
    return sum;
}

static bool fill_bins(Sort *sort, Bins *bins, int threads)
{
    sort->shares = sort->count < FEW ? 1 : threads;
    sort->counts = calloc((size_t)sort->shares * (size_t)sort->bin_count, sizeof *sort->counts);
    bins->start = malloc(((size_t)sort->bin_count + 1) * sizeof *bins->start);
    bins->items = NULL;
    if (sort->counts != NULL && bins->start != NULL) {
        in_parallel(sort->shares, sort->shares, count_share, sort);
        size_t sum = add_up(sort, bins->start);
        sort->items = bins->items = malloc((sum + 1) * sizeof *bins->items);
        if (bins->items != NULL)
            in_parallel(sort->shares, sort->shares, fill_share, sort);
    }
    free(sort->counts);
    return bins->items != NULL;
}

bool bins_by_depth(Bins *bins, const Place *places, int count, int threads)
{
    uint32_t nearest = UINT32_MAX, farthest = 0;
    for (int i = 0; i < count; i++) {
        uint32_t depth = depth_of(places[i]);
        nearest = depth < nearest ? depth : nearest;
        farthest = depth > farthest ? depth : farthest;
    }
    Sort sort = {.places = places, .count = count, .by_depth = true, .nearest = nearest};
    sort.bin_count = sort.columns = count > 0 ? (int)(farthest - nearest) + 1 : 1;
    if (!fill_bins(&sort, bins, threads))
        return false;
    bins->start[1] = bins->start[sort.bin_count];
    return true;
}

bool bins_by_tile(Bins *bins, const Place *places, const Bins *by_depth, int columns, int top,
                  int bottom, int threads)
{
    Sort sort = {.places = places, .order = by_depth->items, .count = (int)by_depth->start[1],
                 .columns = columns, .top = top, .bottom = bottom};
    sort.bin_count = columns * (bottom - top);
    return fill_bins(&sort, bins, threads);
}

void bins_free(Bins *bins)
{
    free(bins->items);
    free(bins->start);
}
