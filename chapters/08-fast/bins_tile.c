// bins_tile.c - one tile of the screen: its spheres ask its pixels, the near ones first, until the
// rest is hidden behind what was seen.
//
// Float decides where its error cannot matter; the bounds are in outline_of. What it leaves open is
// decided by chapter 06's functions, in double, at the end.
#include "chapters/08-fast/bins_tile.h"

#include "exercises/04-pixel-ray.h"
#include "exercises/05-quadratic.h"

#include <float.h>
#include <math.h>

enum { UNTIL_NEXT_LOOK = 16 }; // spheres, until the tile is searched again for its farthest pixel

typedef struct {
    const Tiling *tiling;
    Pixel corner;
    int columns, rows;
    vec3 first, column, row; // the first pixel's ray, and from pixel to pixel
    double shortest;         // at most the length of any of its rays
    float slack;             // how far off any s in it may be
    Tile pixels;
} Here;

static Pixel pixel_at(const Here *here, int column, int row)
{
    return (Pixel){here->corner.column + column, here->corner.row + row};
}

static int color_of(const Tiling *tiling, int sphere)
{
    const Scene *scene = tiling->work->scene;
    int surface = sphere < 0 ? scene->surface_count : scene->spheres[sphere].surface;
    const uint8_t *rgb = tiling->paints[surface].rgb;
    return rgb[0] | rgb[1] << 8 | rgb[2] << 16;
}

// How far lies the sphere's rectangle from the middle, along the columns or the rows?
static double reach(int first, int end, double middle)
{
    return fmax(middle - first, end - 1 - middle);
}

// The sphere as the tile sees it. False where float is not to be trusted with it: where the eye is
// in it or close to it, or it is partly beside or behind the eye, or of an extraordinary size.
//
// By Lagrange's identity D = b^2 - |v|^2 (|c|^2 - r^2) is r^2 |v|^2 - |c x v|^2: there no large
// numbers cancel. Counted from the middle of the sphere's rectangle, no term is much larger than D
// gets in it, so float has D to some 2^-24 of their sum.
static bool outline_of(Here *here, int number, Outline *outline)
{
    const Tiling *tiling = here->tiling;
    Sphere sphere = tiling->work->scene->spheres[number];
    Part part = outline->part;
    vec3 c = sphere.center - tiling->work->camera.origin;
    double x = floor((part.left + part.right) / 2.0), y = floor((part.top + part.bottom) / 2.0);
    vec3 v = here->first + x * here->column + y * here->row;
    double half_x = reach(part.left, part.right, x), half_y = reach(part.top, part.bottom, y);

    double square = sphere.radius * sphere.radius, apart = vec3_dot(c, c);
    vec3 w = vec3_cross(c, v), wx = vec3_cross(c, here->column), wy = vec3_cross(c, here->row);
    double vv = vec3_dot(v, v), ww = vec3_dot(w, w);
    double d = square * vv - ww;
    double dx = 2 * (square * vec3_dot(v, here->column) - vec3_dot(w, wx));
    double dy = 2 * (square * vec3_dot(v, here->row) - vec3_dot(w, wy));
    double dxx = square * vec3_dot(here->column, here->column) - vec3_dot(wx, wx);
    double dxy = 2 * (square * vec3_dot(here->column, here->row) - vec3_dot(wx, wy));
    double dyy = square * vec3_dot(here->row, here->row) - vec3_dot(wy, wy);
    double b = vec3_dot(c, v), bx = vec3_dot(c, here->column), by = vec3_dot(c, here->row);

    // The sum of the terms, and the most and the least that b may be.
    double d_sum = fabs(d) + (fabs(dx) + fabs(dxx) * half_x) * half_x +
                   (fabs(dy) + fabs(dyy) * half_y) * half_y + fabs(dxy) * half_x * half_y;
    double b_range = fabs(bx) * half_x + fabs(by) * half_y, b_sum = fabs(b) + b_range;
    if (!(apart - square > 1e-3 * apart && b - b_range > 1e-6 * b_sum && b_sum < 1e15 &&
          d_sum > 1e-30 && d_sum < 1e30))
        return false;

    // Each term is rounded at most six times, in float; and double is not exact either.
    double d_error = 4 * FLT_EPSILON * d_sum +
                     1e-14 * (square * vv + sqrt(ww * vv * apart));
    double b_error = 3 * FLT_EPSILON * b_sum;
    double u_error = b_error + here->slack;
    // A square root near 0 magnifies its error, so D that small is doubtful, too.
    double doubt = 0x1p-16 * d_sum + 2 * d_error + u_error * u_error;
    double s_error = b_error + FLT_EPSILON * b_sum + d_error / sqrt(doubt);
    if (here->slack < s_error)
        here->slack = (float)(s_error * (1 + 1e-6));
    *outline = (Outline){(float)x, (float)y, (float)d, (float)dx, (float)dy, (float)dxx,
                         (float)dxy, (float)dyy, (float)b, (float)bx, (float)by, (float)doubt,
                         (float)(2 * u_error), part, color_of(tiling, number)};
    return true;
}

// The same by double, pixel by pixel.
static void ask_in_double(Here *here, int number, Part part, float nearest)
{
    const Work *work = here->tiling->work;
    int color = color_of(here->tiling, number);
    for (int row = part.top; row < part.bottom; row++) {
        for (int column = part.left; column < part.right; column++) {
            float *s = &here->pixels.s[row * TILE_WIDTH + column];
            int *seen = &here->pixels.color[row * TILE_WIDTH + column];
            if (nearest > *s + here->slack)
                continue;
            Ray ray = pixel_ray(work->camera, work->image->size, pixel_at(here, column, row));
            double t = hit_sphere(ray, work->scene->spheres[number]);
            if (t == NO_HIT)
                continue;
            double at = t * vec3_dot(ray.direction, ray.direction);
            double margin = 2 * here->slack + 4 * FLT_EPSILON * at;
            if (!(at < FLT_MAX && fabs(at - *s) > margin)) {
                *seen |= UNSURE;
            } else if (at < *s) {
                *s = (float)at;
                *seen = color | (*seen & UNSURE);
                here->slack = fmaxf(here->slack, (float)(FLT_EPSILON * at));
            }
        }
    }
}

// Which of the spheres does a pixel see? Most of them its ray misses by far.
static int decide(const Here *here, Pixel pixel, const int *bin, size_t count)
{
    const Work *work = here->tiling->work;
    Ray ray = pixel_ray(work->camera, work->image->size, pixel);
    vec3 v = ray.direction;
    double vv = vec3_dot(v, v);
    Hit nearest = {NO_HIT, -1};
    for (size_t i = 0; i < count; i++) {
        int number = here->tiling->places[bin[i]].sphere;
        Sphere sphere = work->scene->spheres[number];
        vec3 c = sphere.center - ray.origin, w = vec3_cross(c, v);
        double square = sphere.radius * sphere.radius;
        if (vec3_dot(w, w) > 1.000001 * square * vv + 1e-18 * vec3_dot(c, c) * vv)
            continue;
        double t = hit_sphere(ray, sphere);
        if (t < nearest.t || (t == nearest.t && t < NO_HIT && number < nearest.sphere))
            nearest = (Hit){t, number};
    }
    return nearest.sphere;
}

static void decide_unsure(Here *here, const int *bin, size_t count)
{
    if (!here->tiling->lanes->unsure(&here->pixels))
        return;
    for (int row = 0; row < here->rows; row++) {
        for (int column = 0; column < here->columns; column++) {
            int *seen = &here->pixels.color[row * TILE_WIDTH + column];
            if (*seen & UNSURE)
                *seen = color_of(here->tiling,
                                 decide(here, pixel_at(here, column, row), bin, count));
        }
    }
}

static Part part_of(const Here *here, Place place)
{
    int left = place.left - here->corner.column, right = place.right - here->corner.column;
    int top = place.top - here->corner.row, bottom = place.bottom - here->corner.row;
    return (Part){left > 0 ? left : 0, right < here->columns ? right : here->columns,
                  top > 0 ? top : 0, bottom < here->rows ? bottom : here->rows};
}

// Returns how many of the spheres may be seen at all.
static size_t ask_all(Here *here, const int *bin, size_t count)
{
    const Tiling *tiling = here->tiling;
    const Part all = {0, here->columns, 0, here->rows};
    float farthest = INFINITY;
    int until_next_look = UNTIL_NEXT_LOOK;
    for (size_t i = 0; i < count; i++) {
        if (i + 16 < count)
            __builtin_prefetch(&tiling->places[bin[i + 16]]);
        if (i + 8 < count)
            __builtin_prefetch(
                &tiling->work->scene->spheres[tiling->places[bin[i + 8]].sphere]);
        if (--until_next_look == 0) {
            farthest = tiling->lanes->farthest(&here->pixels, all);
            until_next_look = UNTIL_NEXT_LOOK;
        }
        Place place = tiling->places[bin[i]];
        float nearest = place.near * (float)here->shortest;
        if (nearest > farthest + here->slack)
            return i;
        Outline outline = {.part = part_of(here, place)};
        if (nearest > tiling->lanes->farthest(&here->pixels, outline.part) + here->slack)
            continue;
        if (outline_of(here, place.sphere, &outline))
            tiling->lanes->ask(&here->pixels, &outline);
        else
            ask_in_double(here, place.sphere, outline.part, nearest);
    }
    return count;
}

static double nearest_to(double x, int first, int count)
{
    return fmin(fmax(x, first), first + count) - x;
}

void tile_cast(const Tiling *tiling, Pixel corner, const int *bin, size_t count)
{
    Image *image = tiling->work->image;
    Camera camera = tiling->work->camera;
    int width = image->size.width, height = image->size.height;
    Here here;
    here.tiling = tiling;
    here.corner = corner;
    here.columns = width - corner.column < TILE_WIDTH ? width - corner.column : TILE_WIDTH;
    here.rows = height - corner.row < TILE_HEIGHT ? height - corner.row : TILE_HEIGHT;
    here.first = pixel_ray(camera, image->size, corner).direction;
    here.column = camera.width / width * camera.right;
    here.row = -camera.height / height * camera.up;
    double x = camera.width / width * nearest_to(width / 2.0, corner.column, here.columns);
    double y = camera.height / height * nearest_to(height / 2.0, corner.row, here.rows);
    here.shortest = 0.999999 * sqrt(camera.distance * camera.distance + x * x + y * y);
    here.slack = 0;
    tiling->lanes->clear(&here.pixels, here.columns, here.rows, color_of(tiling, -1));
    decide_unsure(&here, bin, ask_all(&here, bin, count));
    tiling->lanes->paint(
        &here.pixels, here.columns, here.rows,
        image->rgb + 3 * ((size_t)corner.row * (size_t)width + (size_t)corner.column),
        3 * (size_t)width);
}
