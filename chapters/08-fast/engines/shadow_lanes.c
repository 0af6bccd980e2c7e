// shadow_lanes.c - shadow rays, several at a time in doubles: sides of surfaces, cells of a light's
// grid, and what hides the light.
#include "chapters/08-fast/engines/shadow_lanes.h"

#include "chapters/08-fast/engines/any_ray.h"

static inline double dot(double x, double y, double z, double u, double v, double w)
{
    return x * u + y * v + z * w;
}

// If the light is certainly in front of the surface, and this is the outside of its sphere, the ray
// misses the sphere.
static void passes(const Paths *paths, ShadowRays *rays)
{
    const Vectors *ways = rays->way;
    const bool endless = rays->endless;
#pragma omp simd
    for (int i = 0; i < paths->count; i++) {
        double x = ways->x[i], y = ways->y[i], z = ways->z[i];
        double nx = paths->normal.x[i], ny = paths->normal.y[i], nz = paths->normal.z[i];
        double cx = paths->center.x[i], cy = paths->center.y[i], cz = paths->center.z[i];
        double along = dot(nx, ny, nz, x, y, z), squared = dot(x, y, z, x, y, z);
        double size = larger(larger(fabs(cx), fabs(cy)), fabs(cz)) + paths->radius[i];
        double outward =
            dot(nx, ny, nz, paths->point.x[i] - cx, paths->point.y[i] - cy, paths->point.z[i] - cz);
        bool far = endless | (squared > 1e-6 * size * size);
        bool clear = along * along > 1e-4 * squared;
        bool before = clear & (along > 0) & (outward > 0);
        rays->passes[i] = (clear & (along < 0) & far) ? NO_RAY
                          : before                    ? paths->sphere[i]
                                                      : NO_SPHERE;
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

// A ray and a sphere: p is from the start of the ray to the centre, w the way to the light. All
// terms of the discriminant d are times the square of the ray's length, so the margin of any_ray.h
// is right for them, and no root is needed.
typedef struct {
    double wx, wy, wz, px, py, pz, rr, pp, squared, end, ahead, outside, margin, d;
} Meets;

static inline Meets meets(const ShadowRays *rays, int i, double x, double y, double z,
                          double radius)
{
    Meets m;
    m.wx = rays->way->x[i], m.wy = rays->way->y[i], m.wz = rays->way->z[i];
    m.px = x - rays->start->x[i], m.py = y - rays->start->y[i], m.pz = z - rays->start->z[i];
    m.rr = radius * radius;
    m.pp = dot(m.px, m.py, m.pz, m.px, m.py, m.pz);
    m.squared = dot(m.wx, m.wy, m.wz, m.wx, m.wy, m.wz);
    m.end = rays->endless ? INFINITY : m.squared;
    m.ahead = dot(m.px, m.py, m.pz, m.wx, m.wy, m.wz);
    m.outside = m.pp - m.rr;
    m.margin = MARGIN * (m.pp + m.rr);
    m.d = m.ahead * m.ahead - m.outside * m.squared;
    return m;
}

static inline bool passes_beside(Meets m)
{
    return (m.d < -m.margin * m.squared) | ((m.ahead < 0) & (m.outside > m.margin));
}

static inline bool hides(Meets m)
{
    return (m.outside > 4 * m.margin) & (m.d > m.margin * m.squared) &
           (m.ahead < m.end * (1 - MARGIN));
}

// If both ends of the ray are inside the sphere, it does not meet the surface between them. If both
// are outside, and it still comes nearer to the centre at its end, it does not meet it either.
static inline bool ends_before(Meets m)
{
    double qx = m.px - m.wx, qy = m.py - m.wy, qz = m.pz - m.wz, qq = dot(qx, qy, qz, qx, qy, qz);
    double end_margin = 4 * MARGIN * (m.pp + qq + m.rr);
    return ((m.outside < -m.margin) & (qq - m.rr < -end_margin) & (m.end < INFINITY)) |
           ((m.outside > m.margin) & (qq - m.rr > end_margin) & (m.ahead > m.end));
}

static void ask_one(const ShadowRays *rays, const Sphere *spheres, int sphere, int *verdicts)
{
    double x = spheres[sphere].center[0], y = spheres[sphere].center[1];
    double z = spheres[sphere].center[2], radius = spheres[sphere].radius;
#pragma omp simd
    for (int i = 0; i < rays->count; i++) {
        Meets m = meets(rays, i, x, y, z, radius);
        bool own = rays->passes[i] == sphere, beside = passes_beside(m), before = ends_before(m);
        int here = (own | beside | before) ? ARRIVES : hides(m) ? HIDDEN : DOUBTFUL;
        verdicts[i] = here > verdicts[i] ? here : verdicts[i];
    }
}

// ---- the cells of a light ---------------------------------------------------------------------

// A ray that no picture shows has the cell after the last one, which is empty.
static inline int cell_at(double ahead, double right, double up, int picture,
                          const LightCells *cells)
{
    double size = cells->columns, across = size / (2 * cells->slope) / ahead;
    double x = size / 2 + across * right, y = size / 2 - across * up;
    bool shown = (ahead > 0) & (x >= 0) & (x < size) & (y >= 0) & (y < size);
    int row = picture * cells->columns + (int)(shown ? y : 0);
    return shown ? row * cells->columns + (int)(shown ? x : 0)
                 : cells->pictures * cells->columns * cells->columns;
}

static void find_cells(const ShadowRays *rays, const LightCells *cells, int *found)
{
    const double *f = cells->forward, *r = cells->right, *u = cells->up;
    double lx = cells->light[0], ly = cells->light[1], lz = cells->light[2];
    const Vectors *start = rays->start;
    if (cells->pictures == 1) {
#pragma omp simd
        for (int i = 0; i < rays->count; i++) {
            double x = start->x[i] - lx, y = start->y[i] - ly, z = start->z[i] - lz;
            double ahead = cells->parallel ? 1 : dot(x, y, z, f[0], f[1], f[2]);
            found[i] = cell_at(ahead, dot(x, y, z, r[0], r[1], r[2]),
                               dot(x, y, z, u[0], u[1], u[2]), 0, cells);
        }
        return;
    }
#pragma omp simd
    for (int i = 0; i < rays->count; i++) {
        double x = start->x[i] - lx, y = start->y[i] - ly, z = start->z[i] - lz;
        bool is_z = (fabs(z) > fabs(x)) & (fabs(z) > fabs(y)), is_y = !is_z & (fabs(y) > fabs(x));
        double ahead = is_z ? z : is_y ? y : x;
        double right = is_z ? x : is_y ? z : y, up = is_z ? y : is_y ? x : z;
        found[i] = cell_at(fabs(ahead), right, up, (is_z ? 4 : is_y ? 2 : 0) + (ahead < 0), cells);
    }
}

// The distances of the rays' starts from the light, or from the plane of parallel rays.
static void find_reaches(const ShadowRays *rays, const LightCells *cells, float *reaches)
{
    const double *f = cells->forward, *light = cells->light;
    const Vectors *start = rays->start, *way = rays->way;
    const double plane = dot(light[0], light[1], light[2], f[0], f[1], f[2]);
    const bool parallel = cells->parallel;
#pragma omp simd
    for (int i = 0; i < rays->count; i++) {
        double x = way->x[i], y = way->y[i], z = way->z[i];
        double ahead = dot(start->x[i], start->y[i], start->z[i], f[0], f[1], f[2]) - plane;
        reaches[i] = (float)((parallel ? ahead : sqrt(dot(x, y, z, x, y, z))) * (1 + 1e-6));
    }
}

// One ray asks the spheres of its cell, as far as they are nearer to the light than its start.
static inline int ask_cell(const ShadowRays *rays, int ray, const Sphere *spheres, float reach,
                           const Shown *shown, const Shown *end)
{
    for (; shown < end && shown->near <= reach; shown++) {
        if (shown->sphere == rays->passes[ray])
            continue;
        if (shown->sphere == NOT_LISTED)
            return DOUBTFUL;
        const Sphere *sphere = &spheres[shown->sphere];
        Meets m = meets(rays, ray, sphere->center[0], sphere->center[1], sphere->center[2],
                        sphere->radius);
        if (passes_beside(m))
            continue;
        if (hides(m))
            return HIDDEN;
        if (!ends_before(m))
            return DOUBTFUL;
    }
    return ARRIVES;
}

// First all memory that will be needed is asked for, so that the rays do not wait for it.
static void ask_cells(const ShadowRays *rays, const Sphere *spheres, const LightCells *cells,
                      int *verdicts)
{
    int found[PATHS], asking[PATHS], count = 0;
    float reach[PATHS];
    find_cells(rays, cells, found);
    find_reaches(rays, cells, reach);
    for (int i = 0; i < rays->count; i++)
        __builtin_prefetch(&cells->shown[cells->start[found[i]]]);
    for (int i = 0; i < rays->count; i++) {
        uint32_t first = cells->start[found[i]], end = cells->start[found[i] + 1];
        asking[count] = i;
        count += (verdicts[i] != HIDDEN) & (first < end) & (cells->shown[first].near <= reach[i]);
        __builtin_prefetch(&spheres[cells->shown[first].sphere]);
    }
    for (int k = 0; k < count; k++) {
        int i = asking[k];
        int here = ask_cell(rays, i, spheres, reach[i], cells->shown + cells->start[found[i]],
                            cells->shown + cells->start[found[i] + 1]);
        verdicts[i] = here > verdicts[i] ? here : verdicts[i];
    }
}

const ShadowLanes LANES(shadow_lanes) = {passes, units, ask_one, ask_cells};
