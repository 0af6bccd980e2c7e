// bins.c - step 6: object order with bins. Every sphere goes into the bins of its tiles. Then every
// tile asks the spheres of its bin, near ones first, until the others are hidden.
//
// A tile's pixels stay in the cache meanwhile (Fuchs et al., 'Pixel-Planes 5', 1989). Most of the
// hidden spheres are never asked.
#include "chapters/08-fast/engines/bins.h"
#include "chapters/08-fast/engines/hierarchy.h"
#include "chapters/08-fast/engines/questions.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

#include <float.h>
#include <stdlib.h>

// ---- one tile ---------------------------------------------------------------------------------

// Its spheres ask its pixels, the near ones first, until the rest is hidden. Float decides if its
// error cannot matter (bins_lanes.c). At the end, chapter 05's hit_sphere decides the other pixels
// in double.

// The data that all tiles share.
typedef struct {
    const Work *work;
    const BinsLanes *lanes;
    const int *colors;
    int *seen; // if not NULL: gets the sphere that each pixel sees, and the image gets nothing
} Tiling;

// After this many spheres, the farthest pixel is computed again.
enum { UNTIL_NEXT_LOOK = 64 };

// The tile that is being cast.
typedef struct {
    const Tiling *tiling;
    Pixel corner;
    int columns, rows;
    TileRays rays;
    float shortest; // not more than the length of any ray
    float slack;    // the largest error of any s
    TilePixels pixels;
    // The spheres that ask next.
    int waiting;
    Candidates candidates;
    int spheres[OUTLINES];
    Part parts[OUTLINES];
    float nearest[OUTLINES]; // a lower bound of s
} CurrentTile;

// The color of pixels that see a sphere. If spheres are wanted instead, the sphere's number + 1.
static int color_of(const Tiling *tiling, int sphere)
{
    return tiling->seen != NULL ? sphere + 1
                                : sphere_color(tiling->work->scene, tiling->colors, sphere);
}

// Which of the spheres does a pixel see? Its ray misses most of them by far: |c x v| / |v| is its
// distance from the center, and the margins are many times the rounding error of that.
static int decide(const CurrentTile *tile, int column, int row, const Item *bin, size_t count)
{
    const Work *work = tile->tiling->work;
    Pixel pixel = {tile->corner.column + column, tile->corner.row + row};
    Ray ray = pixel_ray(work->camera, work->image->size, pixel);
    vec3 v = ray.direction;
    double vv = vec3_dot(v, v);
    Hit nearest = {NO_HIT, -1};
    for (size_t i = 0; i < count; i++) {
        int number = sphere_of(bin[i]);
        Sphere sphere = work->scene->spheres[number];
        vec3 c = sphere.center - ray.origin, w = vec3_cross(c, v);
        double square = sphere.radius * sphere.radius, ww = vec3_dot(w, w);
        if (ww > 1e-250 && ww > 1.000001 * square * vv + 1e-18 * vec3_dot(c, c) * vv)
            continue;
        nearest = nearer(nearest, (Hit){hit_sphere(ray, sphere), number});
    }
    return nearest.sphere;
}

static void decide_unsure(CurrentTile *tile, const Item *bin, size_t count)
{
    if (!tile->tiling->lanes->unsure(&tile->pixels))
        return;
    for (int row = 0; row < tile->rows; row++) {
        for (int column = 0; column < tile->columns; column++) {
            int *seen = &tile->pixels.color[row * SIDE + column];
            if (*seen & UNSURE)
                *seen = color_of(tile->tiling, decide(tile, column, row, bin, count));
        }
    }
}

// The place of a candidate, from the eye, and the pixels that it may ask.
static void set_candidate(CurrentTile *tile, int i)
{
    const Work *work = tile->tiling->work;
    const Sphere *sphere = &work->scene->spheres[tile->spheres[i]];
    Candidates *to = &tile->candidates;
    vec3 c = sphere->center - work->camera.origin;
    to->x[i] = c[0];
    to->y[i] = c[1];
    to->z[i] = c[2];
    to->radius[i] = sphere->radius;
    Part part = tile->parts[i];
    int column = (part.left + part.right) / 2, row = (part.top + part.bottom) / 2;
    to->column[i] = column;
    to->row[i] = row;
    to->half_width[i] = column - part.left;
    to->half_height[i] = row - part.top;
}

// Do all pixels of a sphere's part see something nearer? If they do not, usually one of the pixels
// in the corners is one of those. Small parts have no others.
static inline bool part_is_hidden(const CurrentTile *tile, Part part, float nearest)
{
    const float *top = &tile->pixels.s[part.top * SIDE];
    const float *bottom = &tile->pixels.s[(part.bottom - 1) * SIDE];
    nearest -= tile->slack;
    const float corners = larger(larger(top[part.left], top[part.right - 1]),
                                 larger(bottom[part.left], bottom[part.right - 1]));
    const bool small = (part.right - part.left <= 2) & (part.bottom - part.top <= 2);
    const bool hidden = nearest > corners;
    if (hidden & !small)
        return nearest > tile->tiling->lanes->farthest(&tile->pixels, part);
    return hidden;
}

static void ask_waiting(CurrentTile *tile)
{
    const BinsLanes *lanes = tile->tiling->lanes;
    Outlines outlines;
    for (int i = 0; i < tile->waiting; i++)
        set_candidate(tile, i);
    lanes->outline(&tile->rays, &tile->candidates, &outlines);
    for (int i = 0; i < tile->waiting; i++) {
        const Part part = tile->parts[i];
        const Pixel corner = tile->corner;
        pixels_are_asked(corner.column + part.left, corner.column + part.right,
                         corner.row + part.top, corner.row + part.bottom);
        if (outlines.safe[i]) {
            lanes->ask(&tile->pixels, &outlines, i, tile->parts[i], tile->slack,
                       color_of(tile->tiling, tile->spheres[i]));
            tile->slack = larger(tile->slack, outlines.s_error[i]);
        } else {
            float farthest = lanes->ask_in_double(&tile->pixels, &tile->rays, &tile->candidates, i,
                                                  tile->parts[i], tile->nearest[i], tile->slack,
                                                  color_of(tile->tiling, tile->spheres[i]));
            tile->slack = larger(tile->slack, FLT_EPSILON * farthest);
        }
    }
    tile->waiting = 0;
}

// Returns the number of spheres that may be visible. The next ones are fetched into the cache: the
// order of the bin is not that of the memory, and a sphere may be in two lines of the cache.
static size_t ask_all(CurrentTile *tile, const Item *bin, size_t count)
{
    const Tiling *tiling = tile->tiling;
    const Part all = {0, tile->columns, 0, tile->rows};
    float farthest = INFINITY;
    size_t i;
    for (i = 0; i < count; i++) {
        if (i + 8 < count) {
            const Sphere *soon = &tiling->work->scene->spheres[sphere_of(bin[i + 8])];
            __builtin_prefetch(soon);
            __builtin_prefetch(&soon->surface);
        }
        if (i % UNTIL_NEXT_LOOK == UNTIL_NEXT_LOOK - 1)
            farthest = tiling->lanes->farthest(&tile->pixels, all);
        float nearest = near_of(bin[i]) * tile->shortest;
        if (nearest > farthest + tile->slack)
            break;
        const Part part = part_of(bin[i]);
        // Without a branch: no processor can predict which spheres are hidden.
        tile->spheres[tile->waiting] = sphere_of(bin[i]);
        tile->parts[tile->waiting] = part;
        tile->nearest[tile->waiting] = nearest;
        tile->waiting += part_is_hidden(tile, part, nearest) ? 0 : 1;
        if (tile->waiting == OUTLINES)
            ask_waiting(tile);
    }
    ask_waiting(tile);
    return i;
}

// The rays from this pixel on. They end on the plane, because the step from one pixel to the next
// is the same there.
static TileRays rays_from(const Work *work, Pixel pixel)
{
    Camera camera = work->camera;
    Resolution screen = work->image->size;
    vec3 column = camera.width / screen.width * camera.right;
    vec3 row = -camera.height / screen.height * camera.up;
    // From the middle of the screen. At the edge of a very wide view, a ray that ends on the plane
    // has lost digits.
    Pixel middle = {screen.width / 2, screen.height / 2};
    vec3 first = ray_to_plane(pixel_ray(camera, screen, middle), camera).direction +
                 (pixel.column - middle.column) * column + (pixel.row - middle.row) * row;
    TileRays rays;
    view_store(rays.first, first);
    view_store(rays.column, column);
    view_store(rays.row, row);
    return rays;
}

// Do all rays of this part hit the sphere, seen from outside? Those that do are inside a cone,
// which is convex, so it is enough to ask the corners. The square of the cosine between c, the
// center from the eye, and a ray of the outline is 1 - radius^2 / c.c; there is a margin for
// rounding.
static bool covers(const TileRays *rays, vec3 c, double radius, Part part)
{
    const double apart = vec3_dot(c, c), square = radius * radius;
    if (!(apart > 1.001 * square && apart < 1e6 * square))
        return false;
    for (int corner = 0; corner < 4; corner++) {
        const double x = corner % 2 == 0 ? part.left : part.right - 1;
        const double y = corner / 2 == 0 ? part.top : part.bottom - 1;
        double vv = 0, cv = 0;
        for (int axis = 0; axis < 3; axis++) {
            double v = rays->first[axis] + x * rays->column[axis] + y * rays->row[axis];
            vv += v * v;
            cv += v * c[axis];
        }
        if (!(cv > 0 && cv * cv > (apart - 0.999 * square) * vv))
            return false;
    }
    return true;
}

// The distance from x to the columns (or rows) of the tile, with a sign, and 0 inside.
static double nearest_to(double x, int first, int count)
{
    return fmin(fmax(x, first), first + count) - x;
}

// All pixels see this sphere, or none if it is -1.
static void give_one(const Tiling *tiling, Pixel corner, int columns, int rows, int sphere)
{
    const Image *image = tiling->work->image;
    const int color = tiling->seen == NULL ? color_of(tiling, sphere) : 0;
    uint8_t row_of_bytes[3 * SIDE];
    for (int i = 0; i < SIDE; i++)
        for (int k = 0; k < 3; k++)
            row_of_bytes[3 * i + k] = (uint8_t)(color >> 8 * k);
    for (int row = 0; row < rows; row++) {
        Pixel first = {corner.column, corner.row + row};
        if (tiling->seen == NULL)
            memcpy(image_bytes(image, first), row_of_bytes, 3 * (size_t)columns);
        for (int i = 0; tiling->seen != NULL && i < columns; i++)
            tiling->seen[image_index(image, first) + (size_t)i] = sphere;
    }
}

// Do all pixels see the nearest sphere? It covers them, and the others begin beyond its outline.
static bool one_covers_all(const CurrentTile *tile, const Item *bin, size_t count)
{
    const Work *work = tile->tiling->work;
    const Part part = part_of(bin[0]), all = {0, tile->columns, 0, tile->rows};
    if (part.left > 0 || part.right < all.right || part.top > 0 || part.bottom < all.bottom)
        return false;
    const Sphere *sphere = &work->scene->spheres[sphere_of(bin[0])];
    const vec3 c = sphere->center - work->camera.origin;
    const double outline = sqrt(vec3_dot(c, c) - sphere->radius * sphere->radius);
    return (count == 1 || near_of(bin[1]) > 1.00001 * outline) &&
           covers(&tile->rays, c, sphere->radius, all);
}

static void give_pixels(const CurrentTile *tile)
{
    const Tiling *tiling = tile->tiling;
    Image *image = tiling->work->image;
    if (tiling->seen == NULL)
        tiling->lanes->paint(tile->pixels.color, SIDE, tile->columns, tile->rows,
                             image_bytes(image, tile->corner), 3 * (size_t)image->size.width);
    for (int row = 0; tiling->seen != NULL && row < tile->rows; row++) {
        Pixel first = {tile->corner.column, tile->corner.row + row};
        int *seen = tiling->seen + image_index(image, first);
        for (int column = 0; column < tile->columns; column++)
            seen[column] = tile->pixels.color[row * SIDE + column] - 1;
    }
}

// Casts the tile with this upper left pixel. The items are those of its bin, in any order; after
// them there is room for the sorted ones.
static void tile_cast(const Tiling *tiling, Pixel corner, Item *items, size_t count)
{
    Image *image = tiling->work->image;
    Camera camera = tiling->work->camera;
    int width = image->size.width, height = image->size.height;
    CurrentTile tile;
    tile.tiling = tiling;
    tile.corner = corner;
    tile.columns = least(width - corner.column, SIDE);
    tile.rows = least(height - corner.row, SIDE);
    if (count == 0) {
        give_one(tiling, corner, tile.columns, tile.rows, -1);
        return;
    }
    tile.rays = rays_from(tiling->work, corner);
    double x = camera.width / width * nearest_to(width / 2.0, corner.column, tile.columns);
    double y = camera.height / height * nearest_to(height / 2.0, corner.row, tile.rows);
    // A little less, so that it is not longer than any ray, in spite of rounding.
    tile.shortest = 0.999999F * (float)sqrt(camera.distance * camera.distance + x * x + y * y);
    tile.slack = 0;
    tile.waiting = 0;
    const Item *bin = tiling->lanes->sort(items, count);
    if (one_covers_all(&tile, bin, count)) {
        give_one(tiling, corner, tile.columns, tile.rows, sphere_of(bin[0]));
        return;
    }
    tile.candidates = (Candidates){0};
    tiling->lanes->clear(&tile.pixels, tile.columns, tile.rows, color_of(tiling, -1));
    decide_unsure(&tile, bin, ask_all(&tile, bin, count));
    give_pixels(&tile);
}

// ---- bins of all tiles ------------------------------------------------------------------------

// For fewer spheres more shares are not worth their cost.
enum { FEW_SPHERES = 10000 };

// Counts or adds a sphere in the bins of its tiles.
static inline void visit_tiles(Bins *bins, const BinsShare *share, int number, Part place,
                               int depth)
{
    const int left = place.left / SIDE, right = (place.right - 1) / SIDE;
    const int top = place.top / SIDE, bottom = (place.bottom - 1) / SIDE;
    // One loop for both: a processor cannot guess whether two tiles are a row or a column.
    int column = left, row = top;
    for (int tiles = (right - left + 1) * (bottom - top + 1); tiles > 0; tiles--) {
        const int tile = row * bins->columns + column;
        const int x = column * SIDE, y = row * SIDE;
        const Part part = {most(place.left - x, 0), least(place.right - x, SIDE),
                           most(place.top - y, 0), least(place.bottom - y, SIDE)};
        const uint32_t at = share->next[tile]++;
        if (bins->items != NULL) {
            bins->items[at] = item_of(depth, part, number);
            __builtin_prefetch(&bins->items[at + 8], 1); // the next line of the cache
        }
        row += column == right;
        column = column == right ? left : column + 1;
    }
}

// Where some spheres are on the screen.
static void find_places(Bins *bins, const Sphere *spheres, int count, Places *places)
{
    Positions positions = {0};
    for (int i = 0; i < count; i++) {
        position_set(&positions, i, spheres[i].center - bins->from, spheres[i].radius);
        __builtin_prefetch(&spheres[i + PLACES]); // for the next call
    }
    if (!LANES_BEST(bins)->place(&bins->eye, &positions, count, places))
        atomic_store(&bins->unusual, true);
}

static void visit_share(void *given, int part)
{
    Bins *bins = given;
    const int spheres = bins->scene->sphere_count;
    for (int k = part, first; (first = k * PLACES) < spheres; k += bins->share_count) {
        const int count = least(spheres - first, PLACES);
        Places *places = &bins->places[k];
        if (bins->items == NULL)
            find_places(bins, &bins->scene->spheres[first], count, places);
        for (int i = 0; i < count; i++) {
            const Part place = {places->left[i], places->right[i], places->top[i],
                                places->bottom[i]};
            const int number = bins->numbers == NULL ? first + i : bins->numbers[first + i];
            if (place.left >= place.right || place.top >= place.bottom || number >= bins->end)
                continue;
            visit_tiles(bins, &bins->shares[part], number, place, places->depth[i]);
        }
    }
}

long long bins_count(Bins *bins, int threads)
{
    const size_t tiles = (size_t)bins->columns * (size_t)bins->rows;
    bins->share_count = bins->scene->sphere_count < FEW_SPHERES ? 1 : least(threads, MOST_SHARES);
    bins->places = lanes_memory((size_t)(bins->scene->sphere_count / PLACES + 1) * sizeof(Places));
    uint32_t *numbers = calloc(2 * (size_t)bins->share_count * tiles, sizeof *numbers);
    bins->shares[0].begin = numbers;
    if (bins->places == NULL || numbers == NULL)
        return -1;
    for (int i = 0; i < bins->share_count; i++, numbers += 2 * tiles)
        bins->shares[i] = (BinsShare){numbers, numbers + tiles};
    in_parallel(bins->share_count, bins->share_count, visit_share, bins);
    // From the numbers of items to where they begin.
    long long sum = 0;
    for (size_t tile = 0; tile < tiles; tile++)
        for (int i = 0; i < bins->share_count; i++) {
            const BinsShare *share = &bins->shares[i];
            const uint32_t count = share->next[tile];
            share->begin[tile] = share->next[tile] = (uint32_t)sum;
            sum += count;
        }
    return sum;
}

bool bins_fill(Bins *bins, long long count)
{
    bins->items = lanes_memory(((size_t)count + 1) * sizeof *bins->items);
    if (bins->items == NULL)
        return false;
    bins->items[count] = 0; // the first item of an empty bin may be read
    in_parallel(bins->share_count, bins->share_count, visit_share, bins);
    return true;
}

void bins_free(Bins *bins)
{
    free(bins->items);
    free(bins->shares[0].begin);
    free(bins->places);
}

// ---- the picture ------------------------------------------------------------------------------

typedef struct {
    Tiling tiling;
    Bins bins;
    atomic_bool failed; // there is not enough memory
} Casting;

Eye eye_of(const Work *work)
{
    Camera camera = work->camera;
    Eye eye = {
        .width = work->image->size.width, .height = work->image->size.height, .margin = ROUNDING};
    view_store(eye.right, camera.right);
    view_store(eye.up, camera.up);
    view_store(eye.forward, camera.forward);
    eye.across = eye.width * camera.distance / camera.width;
    eye.down = eye.height * camera.distance / camera.height;
    return eye;
}

static void cast_tile(void *given, int tile)
{
    enum { FEW_ITEMS = 128 }; // need no malloc
    Casting *casting = given;
    const Bins *bins = &casting->bins;
    Pixel corner = {tile % bins->columns * SIDE, tile / bins->columns * SIDE};
    size_t count = 0;
    for (int i = 0; i < bins->share_count; i++)
        count += bins->shares[i].next[tile] - bins->shares[i].begin[tile];
    Item few[2 * FEW_ITEMS];
    Item *items = count > FEW_ITEMS ? malloc(2 * count * sizeof *items) : few, *to = items;
    if (items == NULL) {
        atomic_store(&casting->failed, true);
        return;
    }
    for (int i = 0; i < bins->share_count; i++) {
        const BinsShare *share = &bins->shares[i];
        const size_t some = share->next[tile] - share->begin[tile];
        memcpy(to, bins->items + share->begin[tile], some * sizeof *to);
        to += some;
    }
    tile_cast(&casting->tiling, corner, items, count);
    if (items != few)
        free(items);
}

// How casting ends. If spheres cover so many tiles that the bins would need too much memory, other
// ways are better.
typedef enum { CAST, EXTREME, TOO_MANY, NO_MEMORY } Outcome;

static Outcome cast_by_bins(Casting *casting)
{
    const Work *work = casting->tiling.work;
    Bins *bins = &casting->bins;
    const long long count = bins_count(bins, work->threads);
    if (bins->unusual && extreme_scene(work))
        return EXTREME;
    if (count > 8LL * work->scene->sphere_count + (1 << 22))
        return TOO_MANY;
    if (count < 0 || casting->tiling.colors == NULL || !bins_fill(bins, count))
        return NO_MEMORY;
    in_parallel(work->threads, bins->columns * bins->rows, cast_tile, casting);
    return casting->failed ? NO_MEMORY : CAST;
}

// Casts a picture, or finds the spheres that its pixels see.
static Outcome cast(const Work *work, int *seen)
{
    const Scene *scene = work->scene;
    Resolution screen = work->image->size;
    if (extreme_camera(work->camera, screen))
        return EXTREME;
    if (scene->sphere_count >= (seen != NULL ? UNSURE - 1 : 1 << ITEM_SPHERE))
        return TOO_MANY;
    int *colors = colors_of(scene);
    Casting casting = {.tiling = {work, LANES_BEST(bins), colors, seen},
                       .bins = {.scene = scene,
                                .from = work->camera.origin,
                                .end = scene->sphere_count,
                                .eye = eye_of(work),
                                .columns = (screen.width + SIDE - 1) / SIDE,
                                .rows = (screen.height + SIDE - 1) / SIDE}};
    Outcome outcome = cast_by_bins(&casting);
    bins_free(&casting.bins);
    free(colors);
    return outcome;
}

bool cast_bins(const Work *work, Message *message)
{
    Outcome outcome = cast(work, NULL);
    if (outcome == EXTREME)
        return cast_extreme(work, message);
    if (outcome == TOO_MANY)
        return cast_tiles(work, message);
    return outcome == CAST ||
           message_set(message, "no memory for the bins of %d spheres", work->scene->sphere_count);
}

bool bins_spheres(const Work *work, int *spheres)
{
    return cast(work, spheres) == CAST;
}
