// shadow_lanes.c - shadow rays, several at a time in doubles: sides of surfaces, cells of a light's
// grid, and what hides the light.
#include "chapters/08-fast/engines/shadow_lanes.h"

#include "chapters/08-fast/engines/any_ray.h"
#include "chapters/08-fast/engines/bins_lanes.h"

static inline double dot(double x, double y, double z, double u, double v, double w)
{
    return x * u + y * v + z * w;
}

static void sides(const Paths *paths, const Vectors *ways, bool has_end, int *sides)
{
#pragma omp simd
    for (int i = 0; i < paths->count; i++) {
        double x = ways->x[i], y = ways->y[i], z = ways->z[i];
        double nx = paths->normal.x[i], ny = paths->normal.y[i], nz = paths->normal.z[i];
        double cx = paths->center.x[i], cy = paths->center.y[i], cz = paths->center.z[i];
        double along = dot(nx, ny, nz, x, y, z), squared = dot(x, y, z, x, y, z);
        double size = larger(larger(fabs(cx), fabs(cy)), fabs(cz)) + paths->radius[i];
        double outward =
            dot(nx, ny, nz, paths->point.x[i] - cx, paths->point.y[i] - cy, paths->point.z[i] - cz);
        bool far = !has_end | (squared > 1e-6 * size * size);
        bool clear = along * along > 1e-4 * squared;
        bool before = clear & (along > 0) & (outward > 0);
        sides[i] = (clear & (along < 0) & far) ? BEHIND : before ? BEFORE : EDGE_ON;
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

static inline int cell_at(double ahead, double right, double up, const ViewNumbers *view)
{
    double x = view->size / 2 + view->across * right / ahead;
    double y = view->size / 2 - view->across * up / ahead;
    bool shown = (ahead > 0) & (x >= 0) & (x < view->size) & (y >= 0) & (y < view->size);
    int column = (int)(shown ? x : 0) / TILE_WIDTH, row = (int)(shown ? y : 0) / TILE_HEIGHT;
    return shown ? row * view->columns + column : -1;
}

static void cells(const double light[3], const ViewNumbers *numbers, int view_count,
                  const ShadowRays *rays, int *views, int *cells)
{
    const double *f = numbers->forward, *r = numbers->right, *u = numbers->up;
    double lx = light[0], ly = light[1], lz = light[2];
    if (view_count == 1) {
#pragma omp simd
        for (int i = 0; i < rays->count; i++) {
            double x = rays->start.x[i] - lx, y = rays->start.y[i] - ly;
            double z = rays->start.z[i] - lz;
            views[i] = 0;
            cells[i] = cell_at(dot(x, y, z, f[0], f[1], f[2]), dot(x, y, z, r[0], r[1], r[2]),
                               dot(x, y, z, u[0], u[1], u[2]), numbers);
        }
        return;
    }
#pragma omp simd
    for (int i = 0; i < rays->count; i++) {
        double x = rays->start.x[i] - lx, y = rays->start.y[i] - ly, z = rays->start.z[i] - lz;
        bool is_z = (fabs(z) > fabs(x)) & (fabs(z) > fabs(y)), is_y = !is_z & (fabs(y) > fabs(x));
        double ahead = is_z ? z : is_y ? y : x;
        views[i] = (is_z ? 4 : is_y ? 2 : 0) + (ahead < 0);
        cells[i] = cell_at(fabs(ahead),
                           is_z   ? x
                           : is_y ? z
                                  : y,
                           is_z   ? y
                           : is_y ? x
                                  : z,
                           &numbers[views[i]]);
    }
}

// Whether a sphere hides the light at the end of a ray. All terms of the discriminant are times the
// square of the ray's length, so the margin of any_ray.h is right for them, and no root is needed.
// If both ends of the ray are inside the sphere, it does not meet the surface between them. If both
// are outside, and it still comes nearer to the centre at its end, it does not meet it either.
static inline int verdict(const ShadowRays *rays, int ray, double x, double y, double z,
                          double radius)
{
    double wx = rays->way.x[ray], wy = rays->way.y[ray], wz = rays->way.z[ray];
    double px = x - rays->start.x[ray], py = y - rays->start.y[ray], pz = z - rays->start.z[ray];
    double squared = dot(wx, wy, wz, wx, wy, wz), rr = radius * radius;
    double pp = dot(px, py, pz, px, py, pz), margin = MARGIN * (pp + rr);
    double ahead = dot(px, py, pz, wx, wy, wz), outside = pp - rr;
    double d = ahead * ahead - outside * squared;
    double qx = px - wx, qy = py - wy, qz = pz - wz, qq = dot(qx, qy, qz, qx, qy, qz);
    double end_margin = 4 * MARGIN * (pp + qq + rr);
    bool both_inside = (outside < -margin) & (qq - rr < -end_margin);
    bool both_before = (outside > margin) & (qq - rr > end_margin) & (ahead > squared);
    bool misses =
        (d < -margin * squared) | ((ahead < 0) & (outside > margin)) | both_inside | both_before;
    bool hides = (outside > 4 * margin) & (d > margin * squared) & (ahead < squared * (1 - MARGIN));
    return misses ? LETS_PASS : hides ? HIDES : MAY_HIDE;
}

static void ask(const ShadowRays *rays, Occluders *occluders)
{
#pragma omp simd
    for (int i = 0; i < occluders->count; i++)
        occluders->verdict[i] =
            verdict(rays, occluders->ray[i], occluders->center.x[i], occluders->center.y[i],
                    occluders->center.z[i], occluders->radius[i]);
}

static bool all_ask(const ShadowRays *rays, const double center[3], double radius, int *verdicts)
{
    double x = center[0], y = center[1], z = center[2];
    int any = 0;
#pragma omp simd reduction(| : any)
    for (int i = 0; i < rays->count; i++) {
        verdicts[i] = verdict(rays, i, x, y, z, radius);
        any |= verdicts[i];
    }
    return any != LETS_PASS;
}

const ShadowLanes LANES(shadow_lanes) = {sides, units, cells, ask, all_ask};
