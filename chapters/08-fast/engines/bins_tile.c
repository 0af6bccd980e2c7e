// bins_tile.c - one tile of the screen: its spheres ask its pixels, the near ones first, until the
// rest is hidden.
//
// Float decides if its error cannot matter (bins_lanes.c). At the end, chapter 05's hit_sphere
// decides the other pixels in double.
#include "chapters/08-fast/engines/bins_tile.h"

#include "chapters/08-fast/engines/covered_pixels.h"
#include "chapters/08-fast/engines/hierarchy.h"
#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

#include <float.h>
#include <math.h>
#include <string.h>

// After this many spheres, the farthest pixel is computed again.
enum { UNTIL_NEXT_LOOK = 64 };

// The tile that is being cast.
typedef struct {
    const Tiling *tiling;
    Pixel corner;
    int columns, rows;
    Rays rays;
    float shortest; // not more than the length of any ray
    float slack;    // the largest error of any s
    Tile pixels;
    // The spheres that ask next.
    int waiting;
    Candidates candidates;
    int spheres[OUTLINES];
    Part parts[OUTLINES];
    float nearest[OUTLINES]; // a lower bound of s
} CurrentTile;

static void allow(CurrentTile *tile, float error)
{
    tile->slack = error > tile->slack ? error : tile->slack;
}

static Ray ray_of(const CurrentTile *tile, int column, int row)
{
    const Work *work = tile->tiling->work;
    Pixel pixel = {tile->corner.column + column, tile->corner.row + row};
    return pixel_ray(work->camera, work->image->size, pixel);
}

// The colour of pixels that see a sphere, or its number. If spheres are wanted instead, the
// sphere's number + 1.
static int color_of(const Tiling *tiling, int sphere)
{
    if (tiling->seen != NULL)
        return sphere + 1;
    const Scene *scene = tiling->work->scene;
    return (int)tiling->colors[sphere < 0 ? scene->surface_count : scene->spheres[sphere].surface];
}

// A sphere asks its pixels by chapter 05. If float cannot hold the t, the pixel remains undecided.
static void ask_by_chapter(CurrentTile *tile, int number, Part part, float nearest)
{
    Sphere sphere = tile->tiling->work->scene->spheres[number];
    int color = color_of(tile->tiling, number);
    for (int row = part.top; row < part.bottom; row++) {
        for (int column = part.left; column < part.right; column++) {
            float *s = &tile->pixels.s[row * TILE_WIDTH + column];
            int *seen = &tile->pixels.color[row * TILE_WIDTH + column];
            if (nearest > *s + tile->slack)
                continue;
            Ray ray = ray_of(tile, column, row);
            double t = hit_sphere(ray, sphere);
            if (t == NO_HIT)
                continue;
            vec3 to_plane = ray_to_plane(ray, tile->tiling->work->camera).direction;
            double at = t * vec3_dot(ray.direction, to_plane);
            double margin = 2 * tile->slack + 4 * FLT_EPSILON * at;
            if (!(at > 1e-30 && at < 1e30 && fabs(at - *s) > margin)) {
                *seen |= UNSURE;
            } else if (at < *s) {
                *s = (float)at;
                *seen = color | (*seen & UNSURE);
                allow(tile, (float)(FLT_EPSILON * at));
            }
        }
    }
}

// A sphere asks its pixels in double. If the eye is almost on the sphere, |c|^2 - r^2 loses its
// digits even in double, and chapter 05 decides.
static void ask_in_double(CurrentTile *tile, int number, Part part, float nearest)
{
    const Sphere *sphere = &tile->tiling->work->scene->spheres[number];
    vec3 c = sphere->center - tile->tiling->work->camera.origin;
    double center[3] = {c[0], c[1], c[2]}, r = sphere->radius, rr = r * r, cc = vec3_dot(c, c);
    if (!(fabs(cc - rr) > 1e-6 * (cc + rr))) {
        ask_by_chapter(tile, number, part, nearest);
        return;
    }
    float most =
        tile->tiling->lanes->ask_in_double(&tile->pixels, &tile->rays, center, r, part, nearest,
                                           tile->slack, color_of(tile->tiling, number));
    allow(tile, FLT_EPSILON * most);
}

static inline int sphere_of(Item item)
{
    return (int)(item & ((1 << ITEM_SPHERE) - 1));
}

static inline Part part_of(Item item)
{
    int part = (int)(item >> ITEM_SPHERE & ((1 << ITEM_PART) - 1));
    return (Part){part / (TILE_WIDTH * TILE_HEIGHT * TILE_HEIGHT),
                  part / (TILE_HEIGHT * TILE_HEIGHT) % TILE_WIDTH + 1,
                  part / TILE_HEIGHT % TILE_HEIGHT, part % TILE_HEIGHT + 1};
}

// The least distance from the eye, rounded down.
static inline float near_of(Item item)
{
    uint32_t bits = (uint32_t)(item >> (ITEM_SPHERE + ITEM_PART)) << PLACE_DROPPED;
    float near;
    memcpy(&near, &bits, sizeof near);
    return near;
}

// Which of the spheres does a pixel see? Its ray misses most of them by far: |c x v| / |v| is its
// distance from the centre, and the margins are many times the rounding error of that.
static int decide(const CurrentTile *tile, Ray ray, const Item *bin, size_t count)
{
    vec3 v = ray.direction;
    double vv = vec3_dot(v, v);
    Hit nearest = {NO_HIT, -1};
    for (size_t i = 0; i < count; i++) {
        int number = sphere_of(bin[i]);
        Sphere sphere = tile->tiling->work->scene->spheres[number];
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
            int *seen = &tile->pixels.color[row * TILE_WIDTH + column];
            if (*seen & UNSURE)
                *seen = color_of(tile->tiling, decide(tile, ray_of(tile, column, row), bin, count));
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

static inline float larger(float a, float b)
{
    return a > b ? a : b;
}

// Do all pixels of a sphere's part see something nearer? If they do not, usually one of the pixels
// in the corners is one of those. Small parts have no others.
static inline bool is_hidden(const CurrentTile *tile, Part part, float nearest)
{
    const float *top = &tile->pixels.s[part.top * TILE_WIDTH];
    const float *bottom = &tile->pixels.s[(part.bottom - 1) * TILE_WIDTH];
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
        if (outlines.safe[i]) {
            lanes->ask(&tile->pixels, &outlines, i, tile->parts[i], tile->slack,
                       color_of(tile->tiling, tile->spheres[i]));
            allow(tile, outlines.s_error[i]);
        } else {
            ask_in_double(tile, tile->spheres[i], tile->parts[i], tile->nearest[i]);
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
        tile->waiting += is_hidden(tile, part, nearest) ? 0 : 1;
        if (tile->waiting == OUTLINES)
            ask_waiting(tile);
    }
    ask_waiting(tile);
    return i;
}

Rays rays_from(const Work *work, Pixel pixel)
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
    Rays rays = {.columns = vec3_dot(column, column),
                 .rows = vec3_dot(row, row),
                 .both = vec3_dot(column, row)};
    view_store(rays.first, first);
    view_store(rays.column, column);
    view_store(rays.row, row);
    return rays;
}

bool covers(const Rays *rays, vec3 c, double radius, Part part)
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

// The bytes that will be written are fetched into the cache meanwhile.
static void fetch_bytes(const CurrentTile *tile)
{
    Image *image = tile->tiling->work->image;
    for (int row = 0; row < tile->rows; row++) {
        const uint8_t *rgb =
            image_bytes(image, (Pixel){tile->corner.column, tile->corner.row + row});
        __builtin_prefetch(rgb, 1);
        __builtin_prefetch(rgb + 3 * tile->columns - 1, 1);
    }
}

static void give_spheres(const CurrentTile *tile)
{
    const Image *image = tile->tiling->work->image;
    for (int row = 0; row < tile->rows; row++) {
        Pixel first = {tile->corner.column, tile->corner.row + row};
        int *seen = tile->tiling->seen + image_index(image, first);
        for (int column = 0; column < tile->columns; column++)
            seen[column] = tile->pixels.color[row * TILE_WIDTH + column] - 1;
    }
}

// The numbers of the colours of pixels that all see this sphere, or none if it is -1.
static void give_one_flat(const Tiling *tiling, Pixel corner, int columns, int rows, int sphere)
{
    const Image *image = tiling->work->image;
    const int number = color_of(tiling, sphere);
    for (int row = 0; row < rows; row++) {
        Pixel first = {corner.column, corner.row + row};
        memset(tiling->flat->numbers + image_index(image, first), number, (size_t)columns);
    }
    flat_are_seen(tiling->flat, 1U << number);
}

// All pixels see this sphere, or none if it is -1.
static void give_one(const Tiling *tiling, Pixel corner, int columns, int rows, int sphere)
{
    const Image *image = tiling->work->image;
    if (tiling->flat != NULL) {
        give_one_flat(tiling, corner, columns, rows, sphere);
        return;
    }
    const int color = tiling->seen == NULL ? color_of(tiling, sphere) : 0;
    uint8_t row_of_bytes[3 * TILE_WIDTH];
    for (int i = 0; i < TILE_WIDTH; i++)
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
    return (count == 1 || near_of(bin[1]) > beyond_outline(c, sphere->radius)) &&
           covers(&tile->rays, c, sphere->radius, all);
}

static void give_pixels(const CurrentTile *tile)
{
    const Tiling *tiling = tile->tiling;
    Image *image = tiling->work->image;
    const size_t width = (size_t)image->size.width;
    if (tiling->seen != NULL) {
        give_spheres(tile);
    } else if (tiling->flat != NULL) {
        uint8_t *numbers = tiling->flat->numbers + image_index(image, tile->corner);
        uint32_t set =
            tiling->lanes->paint_flat(&tile->pixels, tile->columns, tile->rows, numbers, width);
        flat_are_seen(tiling->flat, set);
    } else {
        tiling->lanes->paint(&tile->pixels, tile->columns, tile->rows,
                             image_bytes(image, tile->corner), 3 * width);
    }
}

void tile_cast(const Tiling *tiling, Pixel corner, Item *items, size_t count)
{
    Image *image = tiling->work->image;
    Camera camera = tiling->work->camera;
    int width = image->size.width, height = image->size.height;
    CurrentTile tile;
    tile.tiling = tiling;
    tile.corner = corner;
    tile.columns = width - corner.column < TILE_WIDTH ? width - corner.column : TILE_WIDTH;
    tile.rows = height - corner.row < TILE_HEIGHT ? height - corner.row : TILE_HEIGHT;
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
    if (tiling->seen == NULL && tiling->flat == NULL)
        fetch_bytes(&tile);
    tiling->lanes->clear(&tile.pixels, tile.columns, tile.rows, color_of(tiling, -1));
    decide_unsure(&tile, bin, ask_all(&tile, bin, count));
    give_pixels(&tile);
}
