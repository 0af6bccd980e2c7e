// shadow_lanes.c - shadow rays, many at once.
#include "chapters/08-fast/engines/shadow_lanes.h"

#include "chapters/08-fast/engines/meeting.h"

static inline double dot(double x, double y, double z, double u, double v, double w)
{
    return x * u + y * v + z * w;
}

static void behind(const Paths *paths, const Vectors *ways, bool has_end, int *behind)
{
#pragma omp simd
    for (int i = 0; i < paths->count; i++) {
        double x = ways->x[i], y = ways->y[i], z = ways->z[i];
        double along = dot(paths->normal.x[i], paths->normal.y[i], paths->normal.z[i], x, y, z);
        double squared = dot(x, y, z, x, y, z);
        double size = larger(fabs(paths->center.x[i]), fabs(paths->center.y[i]));
        size = paths->radius[i] + larger(size, fabs(paths->center.z[i]));
        bool far = !has_end | (squared > 1e-6 * size * size);
        behind[i] = (along < 0) & (along * along > 1e-4 * squared) & far;
    }
}

static void units(const Vectors *directions, int count, double *lengths, Vectors *units)
{
#pragma omp simd
    for (int i = 0; i < count; i++) {
        double x = directions->x[i], y = directions->y[i], z = directions->z[i];
        lengths[i] = sqrt(dot(x, y, z, x, y, z));
    }
    if (units == NULL)
        return;
#pragma omp simd
    for (int i = 0; i < count; i++) {
        units->x[i] = directions->x[i] / lengths[i];
        units->y[i] = directions->y[i] / lengths[i];
        units->z[i] = directions->z[i] / lengths[i];
    }
}

static void cells(const Eye *view, const double light[3], int columns, const ShadowRays *rays,
                  int *cells)
{
    const double *f = view->forward, *r = view->right, *u = view->up;
#pragma omp simd
    for (int i = 0; i < rays->count; i++) {
        double px = rays->start.x[i] - light[0], py = rays->start.y[i] - light[1];
        double pz = rays->start.z[i] - light[2];
        double ahead = dot(px, py, pz, f[0], f[1], f[2]);
        double x = view->width / 2 + view->across * dot(px, py, pz, r[0], r[1], r[2]) / ahead;
        double y = view->height / 2 - view->down * dot(px, py, pz, u[0], u[1], u[2]) / ahead;
        bool shown = (ahead > 0) & (x >= 0) & (x < view->width) & (y >= 0) & (y < view->height);
        int column = (int)(shown ? x : 0) / TILE_WIDTH, row = (int)(shown ? y : 0) / TILE_HEIGHT;
        cells[i] = shown ? row * columns + column : -1;
    }
}

// With the square of the ray's length, all terms of its discriminant have the margin of meeting.h,
// and no root is needed. If both ends are inside, the ray does not reach the surface between them.
static void ask(const ShadowRays *rays, Occluders *occluders)
{
#pragma omp simd
    for (int i = 0; i < occluders->count; i++) {
        int ray = occluders->ray[i];
        double wx = rays->way.x[ray], wy = rays->way.y[ray], wz = rays->way.z[ray];
        double px = occluders->center.x[i] - rays->start.x[ray];
        double py = occluders->center.y[i] - rays->start.y[ray];
        double pz = occluders->center.z[i] - rays->start.z[ray];
        double squared = dot(wx, wy, wz, wx, wy, wz),
               rr = occluders->radius[i] * occluders->radius[i];
        double pp = dot(px, py, pz, px, py, pz), margin = MARGIN * (pp + rr);
        double ahead = dot(px, py, pz, wx, wy, wz), outside = pp - rr;
        double d = ahead * ahead - outside * squared;
        double qx = px - wx, qy = py - wy, qz = pz - wz, qq = dot(qx, qy, qz, qx, qy, qz);
        bool misses = (d < -margin * squared) | ((ahead < 0) & (outside > margin)) |
                      ((outside < -margin) & (qq - rr < -4 * MARGIN * (pp + qq + rr)));
        bool hides =
            (outside > 4 * margin) & (d > margin * squared) & (ahead < squared * (1 - MARGIN));
        occluders->verdict[i] = misses ? LETS_PASS : hides ? HIDES : MAY_HIDE;
    }
}

const ShadowLanes LANES(shadow_lanes) = {behind, units, cells, ask};
