// bins.c - step 6: object order with bins. Every sphere goes into the bins of its tiles. Then every
// tile asks the spheres of its bin, near ones first, until the others are hidden.
//
// A tile's pixels stay in the cache meanwhile (Fuchs et al., 'Pixel-Planes 5', 1989). Most of the
// hidden spheres are never asked. Many do not even get into a bin: if a large sphere covers a whole
// tile, all that begins beyond it is hidden there.
#include "chapters/08-fast/engines/bins_tile.h"
#include "chapters/08-fast/engines/covered_pixels.h"
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/number_limits.h"
#include "chapters/08-fast/engines/parallel.h"
#include "chapters/08-fast/engines/sphere_colors.h"
#include "common/image_flat.h"
#include "common/large_pages.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

static const BinsLanes *const bins_lanes[LANES_KINDS] = LANES_TABLE(bins);

enum { SMALLEST_CHUNK = 128, LARGEST_CHUNK = 1024, MORE_MEMORY = 1 << 21 }; // bytes
// For fewer than FEW_SPHERES more shares are not worth their cost, and for fewer than
// HIDING_SPHERES hiding is not. At most FEW_ITEMS of a bin need no malloc.
enum { FEW_SPHERES = 10000, HIDING_SPHERES = 1000, FEW_ITEMS = 128 };
enum { MOST_AT_A_TURN = 8 };  // times PLACES spheres, that a share adds before the next share's
enum { FEW_SURFACES = 1000 }; // if there are more, the program does not count the different colours

// A bin is a list of chunks. Each begins at a multiple of its size, which is a power of 2, so the
// address of the next item shows whether the chunk is full.
typedef struct Chunk {
    struct Chunk *before;
    size_t earlier; // items in the chunks before
    Item items[];
} Chunk;

// More memory for chunks.
typedef struct Block {
    struct Block *before;
} Block;

// Each thread has a share of the spheres, and bins of its own: no thread waits for another.
typedef struct {
    Item **next;      // of each bin: the address of its next item; NULL if the bin is empty
    char *free, *end; // of its memory
    Block *block;     // the last one that it needed
    long long room;   // number of chunks that it may still use
} Share;

typedef struct {
    Tiling tiling;
    Eye eye;
    Rays rays; // of the screen
    Share *shares;
    int share_count;
    // The first memory of all shares. One thread allocates it, because malloc keeps that thread's
    // memory for the next picture. It gives the other threads' memory back, and the system clears
    // the pages again.
    char *memory;
    size_t share_memory; // bytes of each share
    size_t chunk;        // bytes
    int columns, rows;   // of tiles
    int top, bottom;     // the rows that have bins
    // Of each tile: the depth beyond which all spheres are hidden. A thread that does not know the
    // latest value only keeps a sphere that it could drop.
    _Atomic uint16_t *hidden;
    // Of each row of tiles: those that are not cast yet.
    atomic_int *left;
    atomic_bool extreme; // some sphere has extreme numbers (number_limits.h)
    atomic_bool full;    // the bins need more memory than they should
    atomic_bool failed;  // there is not enough memory
} Casting;

static Eye eye_of(const Work *work)
{
    Camera camera = work->camera;
    Eye eye = {.width = work->image->size.width, .height = work->image->size.height};
    view_store(eye.right, camera.right);
    view_store(eye.up, camera.up);
    view_store(eye.forward, camera.forward);
    eye.across = eye.width * camera.distance / camera.width;
    eye.down = eye.height * camera.distance / camera.height;
    return eye;
}

// ---- bins -------------------------------------------------------------------------------------

static void set_memory(Share *share, char *memory, size_t size, size_t chunk)
{
    share->free = memory + (chunk - (uintptr_t)memory % chunk) % chunk;
    share->end = memory + size;
}

static bool add_block(Share *share, size_t chunk)
{
    Block *block = large_memory(MORE_MEMORY);
    if (block == NULL)
        return false;
    block->before = share->block;
    share->block = block;
    set_memory(share, (char *)(block + 1), MORE_MEMORY - sizeof *block, chunk);
    return true;
}

static void free_blocks(Share *share)
{
    while (share->block != NULL) {
        Block *before = share->block->before;
        free(share->block);
        share->block = before;
    }
}

static inline bool is_full(const Item *next, size_t chunk)
{
    return ((uintptr_t)next & (chunk - 1)) == 0;
}

// The chunk that ends at the address of a next item, or has it inside.
static inline Chunk *chunk_of(Item *next, size_t chunk)
{
    return (Chunk *)(((uintptr_t)next - 1) & ~(uintptr_t)(chunk - 1));
}

static size_t count_items(Item *next, size_t chunk)
{
    if (next == NULL)
        return 0;
    const Chunk *last = chunk_of(next, chunk);
    return last->earlier + (size_t)(next - last->items);
}

// Returns the address of the first item in a new chunk; NULL if there is no room.
static Item *add_chunk(Casting *casting, Share *share, Item *next)
{
    const size_t size = casting->chunk;
    if (share->room == 0) {
        atomic_store(&casting->full, true);
        return NULL;
    }
    if (share->end - share->free < (ptrdiff_t)size && !add_block(share, size)) {
        atomic_store(&casting->failed, true);
        return NULL;
    }
    Chunk *chunk = (Chunk *)(void *)share->free;
    chunk->before = next == NULL ? NULL : chunk_of(next, size);
    chunk->earlier = count_items(next, size);
    share->free += size;
    share->room--;
    return chunk->items;
}

// Copies the items of a bin. The last chunk comes first; the one before it is fetched into the
// cache meanwhile.
static void copy_items(Item *next, size_t size, Item *to)
{
    if (next == NULL)
        return;
    const Chunk *chunk = chunk_of(next, size);
    size_t count = (size_t)(next - chunk->items);
    for (; chunk != NULL; chunk = chunk->before) {
        for (size_t i = 0; chunk->before != NULL && i < size; i += 64)
            __builtin_prefetch((const char *)chunk->before + i);
        memcpy(to + chunk->earlier, chunk->items, count * sizeof *to);
        count = (size - sizeof *chunk) / sizeof *chunk->items;
    }
}

static inline int most(int a, int b)
{
    return a > b ? a : b;
}

static inline int least(int a, int b)
{
    return a < b ? a : b;
}

// ---- spheres ----------------------------------------------------------------------------------

// In the tiles that a large sphere covers, all that begins beyond its outline is hidden.
static void hide(Casting *casting, Place place)
{
    const Work *work = casting->tiling.work;
    const Sphere *sphere = &work->scene->spheres[place.sphere];
    vec3 c = sphere->center - work->camera.origin;
    const int depth = depth_of((float)beyond_outline(c, sphere->radius));
    for (int row = (place.top + TILE_HEIGHT - 1) / TILE_HEIGHT;
         (row + 1) * TILE_HEIGHT <= place.bottom; row++)
        for (int column = (place.left + TILE_WIDTH - 1) / TILE_WIDTH;
             (column + 1) * TILE_WIDTH <= place.right; column++) {
            _Atomic uint16_t *hidden = &casting->hidden[row * casting->columns + column];
            const Part part = {column * TILE_WIDTH, (column + 1) * TILE_WIDTH, row * TILE_HEIGHT,
                               (row + 1) * TILE_HEIGHT};
            if (depth < atomic_load_explicit(hidden, memory_order_relaxed) &&
                covers(&casting->rays, c, sphere->radius, part))
                atomic_store_explicit(hidden, (uint16_t)depth, memory_order_relaxed);
        }
}

static inline bool is_hidden(const Casting *casting, int depth, int tile)
{
    return depth > atomic_load_explicit(&casting->hidden[tile], memory_order_relaxed);
}

// False if there is no room.
static inline bool add_item(Casting *casting, Share *share, int tile, Item item)
{
    Item *next = share->next[tile];
    if (is_full(next, casting->chunk) && (next = add_chunk(casting, share, next)) == NULL)
        return false;
    *next = item;
    share->next[tile] = next + 1;
    __builtin_prefetch(next + 8, 1); // the next line of the cache
    return true;
}

// Adds a sphere to the bins of its tiles. False if there is no room.
static bool add_place(Casting *casting, Share *share, Place place)
{
    const int left = place.left / TILE_WIDTH, right = (place.right - 1) / TILE_WIDTH;
    const int top = most(place.top / TILE_HEIGHT, casting->top);
    const int bottom = least((place.bottom - 1) / TILE_HEIGHT, casting->bottom - 1);
    const int depth = (int)place_depth(place);
    if (right > left + 1 && bottom > top + 1 &&
        casting->tiling.work->scene->sphere_count >= HIDING_SPHERES)
        hide(casting, place);
    // One loop for both: a processor cannot guess whether two tiles are a row or a column.
    int column = left, row = top;
    for (int tiles = (right - left + 1) * (bottom - top + 1); tiles > 0; tiles--) {
        const int tile = row * casting->columns + column;
        const int part = part_in(&place, column * TILE_WIDTH, row * TILE_HEIGHT);
        if (!is_hidden(casting, depth, tile) &&
            !add_item(casting, share, tile, item_of(depth, part, place.sphere)))
            return false;
        row += column == right;
        column = column == right ? left : column + 1;
    }
    return true;
}

// Adds the spheres at these places. False if there is no room.
static bool add_places(Casting *casting, Share *share, const Places *places, int first, int count)
{
    // Lists without branches: a processor would often guess wrong which spheres are hidden.
    int in_one[PLACES], in_some[PLACES], ones = 0, others = 0;
    for (int i = 0; i < count; i++) {
        const bool seen = !is_hidden(casting, places->depth[i], places->tile[i]);
        in_one[ones] = in_some[others] = i;
        ones += seen & (places->kind[i] == IN_ONE_TILE);
        others += places->kind[i] == IN_TILES;
    }
    const int begin = casting->top * casting->columns, end = casting->bottom * casting->columns;
    for (int k = 0; k < ones; k++) {
        const int i = in_one[k], tile = places->tile[i];
        const Item item = item_of(places->depth[i], places->part[i], first + i);
        if (tile >= begin && tile < end && !add_item(casting, share, tile, item))
            return false;
    }
    for (int k = 0; k < others; k++)
        if (!add_place(casting, share, place_at(places, in_some[k], first + in_some[k])))
            return false;
    return true;
}

// With positions for their places, which need not be cleared between two calls.
static bool add_spheres(Casting *casting, Share *share, Positions *positions, int first, int count)
{
    const Work *work = casting->tiling.work;
    const Sphere *spheres = &work->scene->spheres[first];
    Places places;
    for (int i = 0; i < count; i++) {
        vec3 c = spheres[i].center - work->camera.origin;
        positions->x[i] = c[0];
        positions->y[i] = c[1];
        positions->z[i] = c[2];
        positions->radius[i] = spheres[i].radius;
        if (first + i + PLACES < work->scene->sphere_count)
            __builtin_prefetch(&spheres[i + PLACES]); // for the next call
    }
    bool extreme = false;
    if (!casting->tiling.lanes->place(&casting->eye, positions, count, &places))
        for (int i = 0; i < count; i++)
            extreme |= extreme_sphere(work->camera.origin, &spheres[i]);
    if (extreme)
        atomic_store(&casting->extreme, true);
    return !extreme && add_places(casting, share, &places, first, count);
}

// The shares take turns, so that the large spheres at the beginning of many scenes are soon known.
static void fill_share(void *given, int part)
{
    Casting *casting = given;
    const int count = casting->tiling.work->scene->sphere_count;
    Positions positions = {0};
    const int some = count / (4 * casting->share_count * PLACES) + 1; // so that all have turns
    const int size = PLACES * least(some, MOST_AT_A_TURN);
    for (int turn = size * part; turn < count; turn += size * casting->share_count)
        for (int first = turn; first < least(turn + size, count); first += PLACES)
            if (!add_spheres(casting, &casting->shares[part], &positions, first,
                             least(count - first, PLACES)))
                return;
}

// ---- the picture ------------------------------------------------------------------------------

static void cast_tile(void *given, int part)
{
    Casting *casting = given;
    int tile = casting->top * casting->columns + part;
    Pixel corner = {tile % casting->columns * TILE_WIDTH, tile / casting->columns * TILE_HEIGHT};
    size_t count = 0;
    for (int i = 0; i < casting->share_count; i++)
        count += count_items(casting->shares[i].next[tile], casting->chunk);
    Item few[2 * FEW_ITEMS];
    Item *items = count > FEW_ITEMS ? malloc(2 * count * sizeof *items) : few;
    if (items == NULL) {
        atomic_store(&casting->failed, true);
        return;
    }
    count = 0;
    for (int i = 0; i < casting->share_count; i++) {
        copy_items(casting->shares[i].next[tile], casting->chunk, items + count);
        count += count_items(casting->shares[i].next[tile], casting->chunk);
    }
    // The next tile's items are fetched into the cache meanwhile.
    for (int i = 0; i < casting->share_count; i++)
        __builtin_prefetch(chunk_of(casting->shares[i].next[tile + 1], casting->chunk));
    tile_cast(&casting->tiling, corner, items, count);
    if (items != few)
        free(items);
    const Image *image = casting->tiling.work->image;
    FlatImage *flat = casting->tiling.flat;
    if (atomic_fetch_sub(&casting->left[tile / casting->columns], 1) == 1 && flat != NULL)
        flat_rows_are_set(flat, corner.row, least(TILE_HEIGHT, image->size.height - corner.row));
}

// Empties all bins. If there is a limit, they may have four items for each sphere.
static void empty_bins(Casting *casting, bool limited)
{
    const long long tiles = (long long)casting->columns * casting->rows;
    const long long items = 4LL * casting->tiling.work->scene->sphere_count + (1 << 18);
    const long long bytes = items * (long long)sizeof(Item);
    const long long room = bytes / ((long long)casting->chunk * casting->share_count) + tiles;
    for (int i = 0; i < casting->share_count; i++) {
        Share *share = &casting->shares[i];
        free_blocks(share);
        set_memory(share, casting->memory + (size_t)i * casting->share_memory,
                   casting->share_memory, casting->chunk);
        memset(share->next, 0, ((size_t)tiles + 1) * sizeof(Item *));
        share->room = limited ? room : -1;
    }
    atomic_store(&casting->full, false);
}

// If spheres cover many tiles, all bins together would take too much memory. Then only the bins of
// some rows of tiles are made at a time.
static bool cast_rows(Casting *casting)
{
    const Work *work = casting->tiling.work;
    int step = casting->rows;
    while (casting->top < casting->rows) {
        casting->bottom = least(casting->top + step, casting->rows);
        empty_bins(casting, step > 1);
        in_parallel(casting->share_count, casting->share_count, fill_share, casting);
        if (casting->extreme || casting->failed)
            return false;
        if (casting->full) {
            step = (step + 1) / 2;
            continue;
        }
        in_parallel(work->threads, casting->columns * (casting->bottom - casting->top), cast_tile,
                    casting);
        casting->top = casting->bottom;
    }
    return !casting->failed;
}

static bool shares_create(Casting *casting)
{
    const size_t tiles = (size_t)casting->columns * (size_t)casting->rows;
    // Most small spheres are in one bin, and each bin has a chunk that is not full.
    const size_t items = 5 * (size_t)casting->tiling.work->scene->sphere_count / 4;
    casting->share_memory =
        items * sizeof(Item) / (size_t)casting->share_count + (tiles + 1) * casting->chunk;
    casting->shares = calloc((size_t)casting->share_count, sizeof *casting->shares);
    casting->hidden = malloc(tiles * sizeof *casting->hidden);
    casting->left = malloc((size_t)casting->rows * sizeof *casting->left);
    const size_t bytes = (size_t)casting->share_count * casting->share_memory;
    // Not large_memory: malloc does not keep long arrays that it has to align.
    casting->memory = malloc(bytes);
    large_pages(casting->memory, bytes);
    bool created = casting->shares != NULL && casting->hidden != NULL && casting->left != NULL &&
                   casting->memory != NULL;
    for (int i = 0; i < casting->rows && created; i++)
        atomic_init(&casting->left[i], casting->columns);
    for (int i = 0; i < casting->share_count && created; i++) {
        casting->shares[i].next = malloc((tiles + 1) * sizeof(Item *));
        created = casting->shares[i].next != NULL;
    }
    if (created)
        memset(casting->hidden, 0xff, tiles * sizeof *casting->hidden); // nothing is hidden
    return created;
}

static void shares_free(Casting *casting)
{
    for (int i = 0; i < casting->share_count && casting->shares != NULL; i++) {
        free_blocks(&casting->shares[i]);
        free(casting->shares[i].next);
    }
    free(casting->shares);
    free(casting->hidden);
    free(casting->left);
    free(casting->memory);
}

// The colours of all surfaces, and of the background; or their numbers, if the image becomes flat.
// NULL if there is not enough memory.
static uint32_t *colors_of(const Work *work, bool may_be_flat)
{
    const int count = work->scene->surface_count + 1, spheres = work->scene->sphere_count;
    Paint *paints = paints_of(work->scene);
    uint32_t *colors = paints != NULL ? malloc((size_t)count * sizeof *colors) : NULL;
    for (int i = 0; i < count && colors != NULL; i++)
        colors[i] =
            paints[i].rgb[0] | (uint32_t)paints[i].rgb[1] << 8 | (uint32_t)paints[i].rgb[2] << 16;
    free(paints);
    // Files have a white surface for spheres before the first fill.
    const int unlikely = count > 1 && spheres > 0 ? work->scene->spheres[0].surface : 0;
    if (may_be_flat && count <= FEW_SURFACES && colors != NULL &&
        image_flatten(work->image, colors, count, unlikely))
        for (int i = 0; i < count; i++)
            colors[i] = (uint32_t)flat_number(image_flat(work->image), colors[i]);
    return colors;
}

// Casts a picture, or finds the spheres that its pixels see. False if there is not enough memory,
// or if the scene is extreme.
static bool cast(const Work *work, int *seen, bool *extreme)
{
    Resolution screen = work->image->size;
    const bool may_be_flat = work->may_be_flat && seen == NULL;
    uint32_t *colors = colors_of(work, may_be_flat);
    Casting casting = {.tiling = {work, bins_lanes[lanes_best()], colors,
                                  may_be_flat ? image_flat(work->image) : NULL, seen},
                       .eye = eye_of(work),
                       .rays = rays_from(work, (Pixel){0, 0}),
                       .share_count = work->scene->sphere_count < FEW_SPHERES ? 1 : work->threads,
                       .chunk = SMALLEST_CHUNK,
                       .columns = (screen.width + TILE_WIDTH - 1) / TILE_WIDTH,
                       .rows = (screen.height + TILE_HEIGHT - 1) / TILE_HEIGHT};
    casting.eye.tiles = casting.columns;
    // Large chunks for large bins: few steps from chunk to chunk. Small ones for small bins: little
    // memory that has no items.
    int bin = work->scene->sphere_count / casting.columns / casting.rows;
    while (casting.chunk < LARGEST_CHUNK && casting.chunk < (size_t)bin * sizeof(Item))
        casting.chunk *= 2;
    bool done = shares_create(&casting) && colors != NULL && cast_rows(&casting);
    *extreme = casting.extreme;
    shares_free(&casting);
    free(colors);
    if (!done)
        image_unflatten(work->image);
    return done;
}

bool cast_bins(const Work *work, Message *message)
{
    if (work->scene->sphere_count >> ITEM_SPHERE > 0)
        return cast_tiles(work, message);
    bool extreme = extreme_camera(work->camera);
    if (!extreme && cast(work, NULL, &extreme))
        return true;
    if (extreme)
        return cast_extreme(work, message);
    return message_set(message, "no memory for the bins of %d spheres", work->scene->sphere_count);
}

bool bins_spheres(const Work *work, int *spheres)
{
    bool extreme = extreme_camera(work->camera) || work->scene->sphere_count >= UNSURE - 1;
    return !extreme && cast(work, spheres, &extreme);
}
