// light_grid.c - the bins of step 6, seen from a light.
//
// To build: giants are left out; a view is one picture from the light; its spheres are sorted by
// distance, then into the cells. To ask: shadow rays find their cells, and ask the spheres in them.
#include "chapters/08-fast/engines/light_grid.h"

#include "chapters/08-fast/engines/covered_pixels.h"
#include "chapters/08-fast/engines/parallel.h"
#include "chapters/08-fast/engines/system.h"
#include "exercises/07-shading.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

static const BinsLanes *const bins_lanes[LANES_KINDS] = LANES_TABLE(bins);
static const ShadowLanes *const shadow_lanes[LANES_KINDS] = LANES_TABLE(shadow_lanes);

// A view has MOST_COLUMNS of cells, or half of them, or a quarter, and so on.
enum { MOST_COLUMNS = 1024, COARSEST = 6 };

// Up to this distance from the light, in sizes of the scene, a pixel of a view is much larger than
// all rounding errors.
#define FARTHEST 1e8

// slope: how far the rays at the edges of the view go aside for each step ahead.
static Eye eye_towards(vec3 forward, vec3 right, vec3 up, double slope)
{
    Eye eye = {.width = MOST_COLUMNS * TILE_WIDTH, .height = MOST_COLUMNS * TILE_HEIGHT};
    view_store(eye.forward, forward);
    view_store(eye.right, right);
    view_store(eye.up, up);
    eye.across = eye.width / (2 * slope);
    eye.down = eye.height / (2 * slope);
    return eye;
}

static vec3 along_axis(int axis, double length)
{
    vec3 v = vec3_of(0, 0, 0);
    v[axis % 3] = length;
    return v;
}

// ---- giants -----------------------------------------------------------------------------------

static void include(Crowd *crowd, int i)
{
    const Sphere *sphere = &crowd->scene->spheres[i];
    for (int axis = 0; axis < 3; axis++) {
        double low = sphere->center[axis] - sphere->radius;
        double high = sphere->center[axis] + sphere->radius;
        crowd->low[axis] = low < crowd->low[axis] ? low : crowd->low[axis];
        crowd->high[axis] = high > crowd->high[axis] ? high : crowd->high[axis];
    }
}

// The largest spheres are giants, if together they make the box at least twice as large.
Crowd crowd_of(const Scene *scene)
{
    Crowd crowd = {.scene = scene,
                   .low = vec3_of(INFINITY, INFINITY, INFINITY),
                   .high = -vec3_of(INFINITY, INFINITY, INFINITY)};
    int *giants = crowd.giants, count = 0;
    for (int i = 0; i < scene->sphere_count; i++) { // by insertion, the largest first
        int at = count;
        while (at > 0 && scene->spheres[giants[at - 1]].radius < scene->spheres[i].radius)
            at--;
        if (at == MOST_GIANTS) {
            include(&crowd, i);
            continue;
        }
        if (count == MOST_GIANTS)
            include(&crowd, giants[--count]);
        for (int k = count++; k > at; k--)
            giants[k] = giants[k - 1];
        giants[at] = i;
    }
    while (count > 0) {
        Crowd more = crowd;
        for (int i = 0; i < count; i++)
            include(&more, giants[i]);
        if (vec3_length(more.high - more.low) > 2 * vec3_length(crowd.high - crowd.low))
            break;
        include(&crowd, giants[--count]);
    }
    crowd.giant_count = count;
    return crowd;
}

static bool is_giant(const Crowd *crowd, int sphere)
{
    for (int i = 0; i < crowd->giant_count; i++)
        if (crowd->giants[i] == sphere)
            return true;
    return false;
}

// ---- a counting sort --------------------------------------------------------------------------

// Count the items of each bin, add up where each bin begins, fill.
//
// Every thread has a share of the items and counts separately. The items of share p in bin b come
// after those of all shares in earlier bins, and after those of earlier shares in this bin. So each
// thread knows its places beforehand: all fill at the same time without locks, and items keep their
// order.

// Bin number b holds the items from start[b] to start[b + 1] - 1.
typedef struct {
    int *items;
    size_t *start;
} Bins;

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

// The visible ones of count places, near ones first; all depths are from nearest to farthest.
// Returns their number; -1 if there is not enough memory.
static int places_by_depth(const Place *places, int count, uint32_t nearest, uint32_t farthest,
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

// Sorts count places into the tiles of the rows top to bottom - 1, with columns tiles in each row.
// The places keep their order. False if there is not enough memory. Free it with bins_free.
static bool bins_by_tile(Bins *bins, const Place *places, int count, int columns, int top,
                         int bottom, int threads)
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

static void bins_free(Bins *bins)
{
    free(bins->items);
    free(bins->start);
}

// ---- views ------------------------------------------------------------------------------------

// The number of views, and their directions: towards the crowd, or to all six sides.
static int look_around(LightGrid *grid)
{
    vec3 low = grid->crowd->low, high = grid->crowd->high;
    vec3 towards = (low + high) / 2 - grid->light;
    double size = vec3_length(high - low) / 2, distance = vec3_length(towards);
    if (!(distance < FARTHEST * size))
        return 0;
    if (distance > 1.2 * size) {
        vec3 forward = towards / distance;
        int axis = fabs(forward[0]) < 0.6 ? 0 : 1;
        vec3 right = vec3_unit(vec3_cross(forward, along_axis(axis, 1)));
        double slope = 1.001 * size / sqrt(distance * distance - size * size);
        grid->views[0].eye = eye_towards(forward, right, vec3_cross(right, forward), slope);
        return 1;
    }
    for (int i = 0; i < 6; i++)
        grid->views[i].eye = eye_towards(along_axis(i / 2, i % 2 == 0 ? 1 : -1),
                                         along_axis(i / 2 + 1, 1), along_axis(i / 2 + 2, 1), 1.001);
    return 6;
}

static inline double along(vec3 v, const double axis[3])
{
    return v[0] * axis[0] + v[1] * axis[1] + v[2] * axis[2];
}

// Whether a view may show some of a sphere with this centre from the light: it is not beyond one of
// the view's four sides.
static bool may_show(const Eye *eye, vec3 center, double radius)
{
    double ahead = along(center, eye->forward), slope = eye->width / (2 * eye->across);
    double side = fmax(fabs(along(center, eye->right)), fabs(along(center, eye->up)));
    return side - slope * ahead <= radius * sqrt(1 + slope * slope) * (1 + 1e-9);
}

// Places of all spheres that a view may show. In places, a pixel is covered if its centre is; here
// one more on each side counts, for the rays between the centres. Returns the number of spheres.
static int place_spheres(const LightGrid *grid, const Eye *eye, Place *places)
{
    const Scene *scene = grid->crowd->scene;
    int count = 0, waiting = 0, numbers[PLACES];
    Positions positions = {0};
    for (int i = 0; i < scene->sphere_count; i++) {
        vec3 center = scene->spheres[i].center - grid->light;
        double radius = scene->spheres[i].radius;
        if (may_show(eye, center, radius) && !is_giant(grid->crowd, i)) {
            positions.x[waiting] = center[0];
            positions.y[waiting] = center[1];
            positions.z[waiting] = center[2];
            positions.radius[waiting] = radius;
            numbers[waiting++] = i;
        }
        if (waiting < PLACES && i < scene->sphere_count - 1)
            continue;
        bins_lanes[lanes_best()]->place(eye, &positions, 0, waiting, places + count);
        for (int k = 0; k < waiting; k++) {
            Place *place = &places[count + k];
            place->left = (uint16_t)(place->left - (place->left > 0));
            place->top = (uint16_t)(place->top - (place->top > 0));
            place->right = (uint16_t)(place->right + (place->right < eye->width));
            place->bottom = (uint16_t)(place->bottom + (place->bottom < eye->height));
            place->sphere = numbers[k];
        }
        count += waiting;
        waiting = 0;
    }
    return count;
}

// Makes cells larger, until there are few for each sphere, and few spheres in them.
static void choose_columns(LightView *view, Place *places, int count)
{
    int drop = 0;
    for (;; drop++) {
        long long cells = MOST_COLUMNS >> drop, entries = 0;
        for (int i = 0; i < count; i++)
            entries += (((places[i].right - places[i].left) / TILE_WIDTH >> drop) + 2) *
                       (((places[i].bottom - places[i].top) / TILE_HEIGHT >> drop) + 2);
        if (drop == COARSEST ||
            (cells * cells <= 8LL * count + (1 << 18) && entries <= 8LL * count + (1 << 18)))
            break;
    }
    view->columns = MOST_COLUMNS >> drop;
    view->eye.across /= 1 << drop;
    view->eye.down /= 1 << drop;
    view->eye.width /= 1 << drop;
    view->eye.height /= 1 << drop;
    for (int i = 0; i < count; i++) {
        Place *place = &places[i];
        place->left = (uint16_t)(place->left >> drop);
        place->top = (uint16_t)(place->top >> drop);
        place->right = (uint16_t)(((place->right - 1) >> drop) + 1);
        place->bottom = (uint16_t)(((place->bottom - 1) >> drop) + 1);
    }
}

static void set_numbers(LightView *view)
{
    const Eye *eye = &view->eye;
    view->numbers =
        (ViewNumbers){.across = eye->across, .size = eye->width, .columns = view->columns};
    memcpy(view->numbers.right, eye->right, sizeof eye->right);
    memcpy(view->numbers.up, eye->up, sizeof eye->up);
    memcpy(view->numbers.forward, eye->forward, sizeof eye->forward);
}

static bool view_build(const LightGrid *grid, LightView *view, Place *places, int threads)
{
    int count = place_spheres(grid, &view->eye, places);
    choose_columns(view, places, count);
    uint32_t nearest = UINT32_MAX, farthest = 0;
    for (int i = 0; i < count; i++) {
        uint32_t depth = place_depth(places[i]);
        nearest = depth < nearest ? depth : nearest;
        farthest = depth > farthest ? depth : farthest;
    }
    if (count == 0)
        nearest = farthest;
    Place *sorted = large_memory(((size_t)count + 1) * sizeof *sorted);
    Bins bins = {0};
    int visible =
        sorted == NULL ? -1 : places_by_depth(places, count, nearest, farthest, sorted, threads);
    if (visible >= 0 &&
        bins_by_tile(&bins, sorted, visible, view->columns, 0, view->columns, threads)) {
        size_t entries = bins.start[view->columns * view->columns];
        view->shown = large_memory((entries + 1) * sizeof *view->shown);
        for (size_t i = 0; i < entries && view->shown != NULL; i++)
            view->shown[i] = (Shown){sorted[bins.items[i]].near, sorted[bins.items[i]].sphere};
        size_t cells = (size_t)view->columns * (size_t)view->columns;
        view->start = large_memory((cells + 1) * sizeof *view->start);
        for (size_t i = 0; i <= cells && view->start != NULL; i++)
            view->start[i] = (uint32_t)bins.start[i];
        set_numbers(view);
    }
    free(sorted);
    bins_free(&bins);
    return view->shown != NULL && view->start != NULL;
}

bool light_grid_build(LightGrid *grid, const Crowd *crowd, Light light, int threads)
{
    *grid = (LightGrid){.crowd = crowd, .light = light.position};
    if (light.kind != LIGHT_POINT || crowd->giant_count == crowd->scene->sphere_count)
        return true;
    grid->count = look_around(grid);
    Place *places = large_memory(((size_t)crowd->scene->sphere_count + PLACES) * sizeof *places);
    bool done = places != NULL;
    for (int i = 0; i < grid->count && done; i++)
        done = view_build(grid, &grid->views[i], places, threads);
    free(places);
    return done;
}

void light_grid_free(LightGrid *grid)
{
    for (int i = 0; i < grid->count; i++) {
        free(grid->views[i].shown);
        free(grid->views[i].start);
    }
}

// ---- shadow rays ------------------------------------------------------------------------------

// The spheres of its cell that a ray has still to ask.
typedef struct {
    const Shown *next, *end;
    float reach;
    int passes;
} Remaining;

static void find_cells(const LightGrid *grid, const ShadowRays *rays, Remaining *remaining)
{
    const double light[3] = {grid->light[0], grid->light[1], grid->light[2]};
    ViewNumbers numbers[6];
    int cells[PATHS], views[PATHS];
    for (int i = 0; i < grid->count; i++)
        numbers[i] = grid->views[i].numbers;
    shadow_lanes[lanes_best()]->cells(light, numbers, grid->count, rays, views, cells);
    for (int i = 0; i < rays->count; i++)
        if (cells[i] >= 0)
            __builtin_prefetch(&grid->views[views[i]].start[cells[i]]);
    for (int i = 0; i < rays->count; i++) {
        const LightView *view = &grid->views[views[i]];
        remaining[i] =
            (Remaining){.reach = (float)(rays->length[i] * (1 + 1e-6)), .passes = rays->passes[i]};
        if (cells[i] < 0)
            continue;
        remaining[i].next = view->shown + view->start[cells[i]];
        remaining[i].end = view->shown + view->start[cells[i] + 1];
        __builtin_prefetch(remaining[i].next);
    }
}

static inline int next_sphere(Remaining *remaining)
{
    while (remaining->next < remaining->end && remaining->next->near <= remaining->reach) {
        int sphere = remaining->next++->sphere;
        if (sphere != remaining->passes)
            return sphere;
    }
    return -1;
}

bool hides_light(const Sphere *sphere, vec3 from, const Light *light)
{
    Sphere alone = *sphere;
    Scene world = {.spheres = &alone, .sphere_count = 1};
    return !(visibility(&world, from, *light) > 0);
}

// All rays ask a giant: it hides the light from few of them, so none is left out yet.
static void ask_giant(const Sphere *giant, const Light *light, const ShadowRays *rays, bool *hidden)
{
    const double center[3] = {giant->center[0], giant->center[1], giant->center[2]};
    int verdicts[PATHS];
    if (!shadow_lanes[lanes_best()]->all_ask(rays, center, giant->radius, verdicts))
        return;
    for (int i = 0; i < rays->count; i++)
        hidden[i] |=
            verdicts[i] == HIDES ||
            (verdicts[i] == MAY_HIDE && hides_light(giant, vector_of(&rays->start, i), light));
}

// Each ray that goes on takes its next sphere. Others are done.
static void take_next(const Scene *scene, Remaining *remaining, Occluders *occluders, int *spheres)
{
    int count = 0;
    for (int i = 0; i < occluders->count; i++) {
        int ray = occluders->ray[i], sphere = next_sphere(&remaining[ray]);
        if (sphere < 0)
            continue;
        __builtin_prefetch(&scene->spheres[sphere]);
        spheres[count] = sphere;
        occluders->ray[count++] = ray;
    }
    occluders->count = count;
    for (int i = 0; i < count; i++) {
        set_vector(&occluders->center, i, scene->spheres[spheres[i]].center);
        occluders->radius[i] = scene->spheres[spheres[i]].radius;
    }
}

// All rays ask the giants. Then all that go on ask the first sphere of their cell, those that still
// go on ask their second one, and so on.
void light_grid_hides(const LightGrid *grid, const Light *light, const ShadowRays *rays,
                      bool *hidden)
{
    const Scene *scene = grid->crowd->scene;
    Remaining remaining[PATHS];
    Occluders occluders;
    int spheres[PATHS];
    find_cells(grid, rays, remaining);
    memset(hidden, 0, (size_t)rays->count * sizeof *hidden);
    for (int i = 0; i < grid->crowd->giant_count; i++)
        ask_giant(&scene->spheres[grid->crowd->giants[i]], light, rays, hidden);
    occluders.count = 0;
    for (int i = 0; i < rays->count; i++)
        if (!hidden[i])
            occluders.ray[occluders.count++] = i;
    while (take_next(scene, remaining, &occluders, spheres), occluders.count > 0) {
        shadow_lanes[lanes_best()]->ask(rays, &occluders);
        int left = 0;
        for (int i = 0; i < occluders.count; i++) {
            int ray = occluders.ray[i];
            if (occluders.verdict[i] == HIDES ||
                (occluders.verdict[i] == MAY_HIDE &&
                 hides_light(&scene->spheres[spheres[i]], vector_of(&rays->start, ray), light)))
                hidden[ray] = true;
            else
                occluders.ray[left++] = ray;
        }
        occluders.count = left;
    }
}
