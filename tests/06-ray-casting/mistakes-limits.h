// mistakes-limits.h - limits that no scene has, and nearest_hit's loop with one of them.
#ifndef TESTS_06_RAY_CASTING_MISTAKES_LIMITS_H
#define TESTS_06_RAY_CASTING_MISTAKES_LIMITS_H

#include "tests/06-ray-casting/mistakes.h"

// ---- t, from or up to a limit -------------------------------------------------------------------

#define HIT_BEYOND(name, least)                                                                    \
    static inline double name(Ray ray, Sphere sphere)                                              \
    {                                                                                              \
        return hit_beyond(least, ray, sphere);                                                     \
    }
HIT_BEYOND(hit_beyond_a_tenth, 0.1)
HIT_BEYOND(hit_beyond_a_thousandth, 1e-3)
HIT_BEYOND(hit_beyond_1e_4, 1e-4)
HIT_BEYOND(hit_beyond_1e_5, 1e-5)
HIT_BEYOND(hit_beyond_1e_6, 1e-6)
HIT_BEYOND(hit_beyond_1e_9, 1e-9)

#define HIT_BEFORE(name, most)                                                                     \
    static inline double name(Ray ray, Sphere sphere)                                              \
    {                                                                                              \
        double t = hit_sphere(ray, sphere);                                                        \
        return t < (most) ? t : NO_HIT;                                                            \
    }
HIT_BEFORE(hit_before_100, 100)
HIT_BEFORE(hit_before_1000, 1e3)
HIT_BEFORE(hit_before_10000, 1e4)
HIT_BEFORE(hit_before_1e5, 1e5)
HIT_BEFORE(hit_before_1e6, 1e6)
HIT_BEFORE(hit_before_1e9, 1e9)
HIT_BEFORE(hit_before_1e10, 1e10)
HIT_BEFORE(hit_before_1e12, 1e12)

// ---- nearer by more than a limit ----------------------------------------------------------------

static inline bool nearer_as_floats(double t, double best)
{
    return (float)t < (float)best;
}

#define NEARER_BY(name, epsilon)                                                                   \
    static inline bool name(double t, double best)                                                 \
    {                                                                                              \
        return t < best - (epsilon);                                                               \
    }
NEARER_BY(nearer_by_a_thousandth, 1e-3)
NEARER_BY(nearer_by_a_hundred_thousandth, 1e-5)
NEARER_BY(nearer_by_a_millionth, 1e-6)
NEARER_BY(nearer_by_a_billionth, 1e-9)

// A scene of this many spheres, if it has more.
static inline Scene at_most(int most, const Scene *scene)
{
    Scene some = *scene;
    some.sphere_count = scene->sphere_count < most ? scene->sphere_count : most;
    return some;
}

// ---- the nearest, in one loop -------------------------------------------------------------------

static const Hit nothing = {NO_HIT, -1};

static inline Hit best_of(Hit best, double (*t_of)(Ray ray, Sphere sphere),
                          bool (*replaces)(double t, double best), Ray ray, const Scene *scene)
{
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = t_of(ray, scene->spheres[i]);
        if (replaces(t, best.t))
            best = (Hit){t, i};
    }
    return best;
}

#define LOOP(name, best, t_of, replaces)                                                           \
    static Hit name(Ray ray, const Scene *scene)                                                   \
    {                                                                                              \
        return best_of(best, t_of, replaces, ray, scene);                                          \
    }

#endif
