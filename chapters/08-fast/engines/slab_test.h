// slab_test.h - tests which boxes a ray enters, and which spheres it certainly misses.
#ifndef CHAPTERS_08_FAST_ENGINES_SLAB_TEST_H
#define CHAPTERS_08_FAST_ENGINES_SLAB_TEST_H

#include "chapters/08-fast/engines/hierarchy.h"
#include "common/ray.h"

// A ray and, for each axis, 1 / direction and whether it goes backwards; and 1 / v.v, which is NaN
// if squares would leave the range of a double.
typedef struct {
    double origin[3], inverse[3];
    bool backwards[3];
    double per_squared;
} Way;

static inline Way way_of(Ray ray)
{
    Way way;
    for (int i = 0; i < 3; i++) {
        way.origin[i] = ray.origin[i];
        way.inverse[i] = 1 / ray.direction[i];
        way.backwards[i] = way.inverse[i] < 0;
    }
    double squared = vec3_dot(ray.direction, ray.direction);
    way.per_squared = squared > 1e-100 && squared < 1e100 ? 1 / squared : NAN;
    return way;
}

// The part of the ray between two opposite sides of a box. If the ray is in the plane of a side,
// this is 0 times infinity, NaN; comparing with NaN is false, so it changes nothing.
static inline void clip(const Way *way, int axis, const Box *box, double *enters, double *leaves)
{
    double low = box->low[axis], high = box->high[axis];
    bool backwards = way->backwards[axis];
    double near = ((backwards ? high : low) - way->origin[axis]) * way->inverse[axis];
    double far = ((backwards ? low : high) - way->origin[axis]) * way->inverse[axis];
    *enters = near > *enters ? near : *enters;
    *leaves = far < *leaves ? far : *leaves;
}

// The t at which the ray enters a box (0 if it starts inside); infinite if it misses the box. The
// slabs between opposite sides, one after the other (Kay and Kajiya, 'Ray Tracing Complex Scenes',
// 1986).
static inline double entry(const Box *box, const Way *way)
{
    double enters = 0, leaves = INFINITY;
    clip(way, 0, box, &enters, &leaves);
    clip(way, 1, box, &enters, &leaves);
    clip(way, 2, box, &enters, &leaves);
    return enters <= leaves ? enters : INFINITY;
}

// Whether the ray misses the sphere by so much that rounding cannot make it a hit: by Pythagoras,
// which is faster than chapter 05, and less exact. The margins are many times the rounding error of
// both.
static inline bool surely_misses(const Way *way, Ray ray, const Sphere *sphere)
{
    vec3 p = sphere->center - ray.origin;
    double along = vec3_dot(p, ray.direction), pp = vec3_dot(p, p), r = sphere->radius;
    return pp - along * along * way->per_squared > r * r * (1 + 1e-9) + pp * 1e-12 + 1e-250;
}

#endif
