// bins_sort.c - a counting sort: count the items of each bin, add up where each bin begins, fill.
//
// Every thread has a share of the items and counts separately. The items of share p in bin b come
// after those of all shares in earlier bins, and after those of earlier shares in this bin. So each
// thread knows its places beforehand: all fill at the same time without locks, and items keep their
// order.
#include "chapters/08-fast/engines/bins_sort.h"

#include "chapters/08-fast/engines/large_memory.h"
#include "chapters/08-fast/engines/parallel.h"

#include <stdlib.h>

enum { FEW = 10000 }; // not worth a second thread

typedef struct {
    const Place *places;
    int count;
    Place *sorted;            // by depth
    uint32_t nearest;         // by depth: the least depth
    int columns, top, bottom; // by tile
    int *items;
    int bin_count, shares;
    size_t *counts;  // of each share, bin after bin; later the next place to fill
    size_t *corners; // by tile, of each share; numbers below 0 wrap around, but the sums are right
} Sort;

static bool is_visible(Place place)
{
    return place.left < place.right && place.top < place.bottom;
}

// The tiles of a place, among the rows that have bins: some columns of some rows.
static inline Part tiles_of(const Sort *sort, Place place)
{
    int top = place.top / TILE_HEIGHT, bottom = (place.bottom - 1) / TILE_HEIGHT + 1;
    return (Part){place.left / TILE_WIDTH, (place.right - 1) / TILE_WIDTH + 1,
                  (top > sort->top ? top : sort->top) - sort->top,
                  (bottom < sort->bottom ? bottom : sort->bottom) - sort->top};
}

static int share_begins(const Sort *sort, int share)
{
    return (int)((long long)sort->count * share / sort->shares);
}

static size_t *counts_of(const Sort *sort, int share)
{
    return sort->counts + (size_t)share * (size_t)sort->bin_count;
}

static void count_depths(void *given, int share)
{
    const Sort *sort = given;
    size_t *counts = counts_of(sort, share);
    const Place *end = sort->places + share_begins(sort, share + 1);
    for (const Place *place = sort->places + share_begins(sort, share); place < end; place++)
        counts[place_depth(*place) - sort->nearest] += is_visible(*place);
}

static void fill_depths(void *given, int share)
{
    const Sort *sort = given;
    size_t *next = counts_of(sort, share);
    const Place *end = sort->places + share_begins(sort, share + 1);
    for (const Place *place = sort->places + share_begins(sort, share); place < end; place++) {
        if (!is_visible(*place))
            continue;
        Place *to = &sort->sorted[next[place_depth(*place) - sort->nearest]++];
        *to = *place;
        __builtin_prefetch(to + 8, 1); // two lines of the cache on, in the same bin
    }
}

// A place covers some columns of some rows. Only its four corners are noted; adding up along rows
// and columns gives the counts (Crow, 'Summed-Area Tables for Texture Mapping', 1984, in reverse).
// That is four steps for each place, however many tiles it covers, and the processor need not
// predict the end of a loop.
static void count_tiles(void *given, int share)
{
    const Sort *sort = given;
    size_t *counts = counts_of(sort, share);
    const int columns = sort->columns, rows = sort->bottom - sort->top, wide = columns + 1;
    size_t *corners = sort->corners + (size_t)share * (size_t)(wide * (rows + 1));
    for (int i = share_begins(sort, share), end = share_begins(sort, share + 1); i < end; i++) {
        Part tiles = tiles_of(sort, sort->places[i]);
        if (tiles.top >= tiles.bottom)
            continue;
        corners[tiles.top * wide + tiles.left]++;
        corners[tiles.top * wide + tiles.right]--;
        corners[tiles.bottom * wide + tiles.left]--;
        corners[tiles.bottom * wide + tiles.right]++;
    }
    for (int row = 0; row < rows; row++) {
        size_t in_row = 0;
        for (int column = 0; column < columns; column++) {
            in_row += corners[row * wide + column];
            counts[row * columns + column] =
                in_row + (row > 0 ? counts[(row - 1) * columns + column] : 0);
        }
    }
}

static void fill_tiles(void *given, int share)
{
    const Sort *sort = given;
    size_t *next = counts_of(sort, share);
    int *items = sort->items;
    for (int i = share_begins(sort, share), end = share_begins(sort, share + 1); i < end; i++) {
        Part tiles = tiles_of(sort, sort->places[i]);
        for (int row = tiles.top; row < tiles.bottom; row++)
            for (int column = tiles.left; column < tiles.right; column++)
                items[next[row * sort->columns + column]++] = i;
    }
}

// Turns counts into the places where they begin: a prefix sum. start gets the begin of each bin; it
// may be NULL. Returns the sum of all counts.
static size_t add_up(const Sort *sort, size_t *start)
{
    size_t sum = 0;
    for (int bin = 0; bin < sort->bin_count; bin++) {
        if (start != NULL)
            start[bin] = sum;
        for (int share = 0; share < sort->shares; share++) {
            size_t *count = &sort->counts[(size_t)share * (size_t)sort->bin_count + (size_t)bin];
            size_t here = *count;
            *count = sum;
            sum += here;
        }
    }
    if (start != NULL)
        start[sort->bin_count] = sum;
    return sum;
}

static bool count_all(Sort *sort, void (*count_share)(void *given, int share), int threads)
{
    sort->shares = sort->count < FEW ? 1 : threads;
    sort->counts = calloc((size_t)sort->shares * (size_t)sort->bin_count, sizeof *sort->counts);
    if (sort->counts != NULL)
        in_parallel(sort->shares, sort->shares, count_share, sort);
    return sort->counts != NULL;
}

int places_by_depth(const Place *places, int count, uint32_t nearest, uint32_t farthest,
                    Place *sorted, int threads)
{
    Sort sort = {.places = places, .count = count, .sorted = sorted, .nearest = nearest};
    sort.bin_count = count > 0 ? (int)(farthest - nearest) + 1 : 1;
    if (!count_all(&sort, count_depths, threads))
        return -1;
    int result = (int)add_up(&sort, NULL);
    in_parallel(sort.shares, sort.shares, fill_depths, &sort);
    free(sort.counts);
    return result;
}

bool bins_by_tile(Bins *bins, const Place *places, int count, int columns, int top, int bottom,
                  int threads)
{
    Sort sort = {.places = places,
                 .count = count,
                 .columns = columns,
                 .top = top,
                 .bottom = bottom,
                 .bin_count = columns * (bottom - top)};
    *bins = (Bins){NULL, malloc(((size_t)sort.bin_count + 1) * sizeof *bins->start)};
    sort.corners = calloc((size_t)threads * (size_t)(columns + 1) * (size_t)(bottom - top + 1),
                          sizeof *sort.corners);
    bool counted =
        bins->start != NULL && sort.corners != NULL && count_all(&sort, count_tiles, threads);
    free(sort.corners);
    if (!counted)
        return false;
    size_t sum = add_up(&sort, bins->start);
    sort.items = bins->items = large_memory((sum + 1) * sizeof *bins->items);
    if (bins->items != NULL)
        in_parallel(sort.shares, sort.shares, fill_tiles, &sort);
    free(sort.counts);
    return bins->items != NULL;
}

void bins_free(Bins *bins)
{
    free(bins->items);
    free(bins->start);
}
