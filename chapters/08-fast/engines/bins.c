// bins.c - step 6: object order with bins. Every sphere goes into the bins of its tiles, near
// spheres first. Then every tile asks the spheres of its bin, until the others are hidden.
//
// A tile's pixels stay in the cache meanwhile (Fuchs et al., 'Pixel-Planes 5', 1989). Most of the
// hidden spheres are never asked.
#include "chapters/08-fast/engines/bins_sort.h"
#include "chapters/08-fast/engines/bins_tile.h"
#include "chapters/08-fast/engines/covered_pixels.h"
#include "chapters/08-fast/engines/engine.h"
#include "chapters/08-fast/engines/large_memory.h"
#include "chapters/08-fast/engines/number_limits.h"
#include "chapters/08-fast/engines/parallel.h"

#include <limits.h>
#include <stdatomic.h>
#include <stdlib.h>

static const BinsLanes *const bins_lanes[LANES_KINDS] = LANES_TABLE(bins);

typedef struct {
    Tiling tiling;
    Eye eye;
    Place *places;
    Bins bins;
    int columns, top;              // of tiles; the first row in the bins
    atomic_llong entries;          // upper limit of the items in the bins of all tiles
    atomic_uint nearest, farthest; // depths of places
    atomic_bool extreme;           // some sphere has extreme numbers (number_limits.h)
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

static void make_least(atomic_uint *least, unsigned x)
{
    unsigned was = atomic_load(least);
    while (x < was && !atomic_compare_exchange_weak(least, &was, x))
        ;
}

static void make_most(atomic_uint *most, unsigned x)
{
    unsigned was = atomic_load(most);
    while (x > was && !atomic_compare_exchange_weak(most, &was, x))
        ;
}

static void place_some(void *given, int part)
{
    Casting *casting = given;
    const Work *work = casting->tiling.work;
    int first = part * PLACES, count = work->scene->sphere_count - first;
    if (count > PLACES)
        count = PLACES;
    Positions positions = {0};
    bool extreme = false;
    for (int i = 0; i < count; i++) {
        const Sphere *sphere = &work->scene->spheres[first + i];
        extreme |= extreme_sphere(work->camera.origin, sphere);
        vec3 c = sphere->center - work->camera.origin;
        positions.x[i] = c[0];
        positions.y[i] = c[1];
        positions.z[i] = c[2];
        positions.radius[i] = sphere->radius;
    }
    if (extreme) {
        atomic_store(&casting->extreme, true);
        return;
    }
    Place *places = casting->places + first;
    casting->tiling.lanes->place(&casting->eye, &positions, first, count, places);
    long long entries = 0;
    unsigned nearest = UINT_MAX, farthest = 0;
    for (int i = 0; i < count; i++) {
        unsigned depth = place_depth(places[i]);
        entries += ((places[i].right - places[i].left) / TILE_WIDTH + 2) *
                   ((places[i].bottom - places[i].top) / TILE_HEIGHT + 2);
        nearest = depth < nearest ? depth : nearest;
        farthest = depth > farthest ? depth : farthest;
    }
    atomic_fetch_add(&casting->entries, entries);
    make_least(&casting->nearest, nearest);
    make_most(&casting->farthest, farthest);
}

static void cast_tile(void *given, int tile)
{
    const Casting *casting = given;
    size_t start = casting->bins.start[tile];
    Pixel corner = {tile % casting->columns * TILE_WIDTH,
                    (casting->top + tile / casting->columns) * TILE_HEIGHT};
    tile_cast(&casting->tiling, corner, casting->bins.items + start,
              casting->bins.start[tile + 1] - start);
}

// If spheres cover many tiles, all bins together would take too much memory. Then only the bins of
// some rows of tiles are made at a time.
static bool cast_rows(Casting *casting, int count)
{
    const Work *work = casting->tiling.work;
    int rows = (work->image->size.height + TILE_HEIGHT - 1) / TILE_HEIGHT;
    long long room = 4LL * work->scene->sphere_count + (1 << 20);
    int step = (int)(rows / (casting->entries / room + 1)) + 1;
    bool fits = true;
    for (int top = 0; top < rows && fits; top += step) {
        int bottom = top + step < rows ? top + step : rows;
        casting->top = top;
        fits = bins_by_tile(&casting->bins, casting->tiling.places, count, casting->columns, top,
                            bottom, work->threads);
        if (fits)
            in_parallel(work->threads, casting->columns * (bottom - top), cast_tile, casting);
        bins_free(&casting->bins);
    }
    return fits;
}

// Casts a picture, or finds the spheres that its pixels see. False if there is not enough memory,
// or if the scene is extreme.
static bool cast(const Work *work, int *seen, bool *extreme)
{
    Resolution screen = work->image->size;
    int count = work->scene->sphere_count, parts = (count + PLACES - 1) / PLACES, visible = -1;
    const size_t size = ((size_t)count + 1) * sizeof(Place);
    Place *places = large_memory(size), *sorted = large_memory(size);
    Paint *paints = paints_of(work->scene);
    Casting casting = {.tiling = {work, bins_lanes[lanes_best()], sorted, paints, seen},
                       .eye = eye_of(work),
                       .places = places,
                       .columns = (screen.width + TILE_WIDTH - 1) / TILE_WIDTH,
                       .nearest = UINT_MAX};
    if (places != NULL && sorted != NULL && paints != NULL) {
        // For so few parts, a second thread costs more than it saves.
        in_parallel(parts < 40 ? 1 : work->threads, parts, place_some, &casting);
        if (!casting.extreme)
            visible = places_by_depth(places, count, casting.nearest, casting.farthest, sorted,
                                      work->threads);
    }
    free(places);
    *extreme = casting.extreme;
    bool done = visible >= 0 && cast_rows(&casting, visible);
    free(sorted);
    free(paints);
    return done;
}

bool cast_bins(const Work *work, Message *message)
{
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
