// unknown.c - wrong answers to exercise 05 that are not known mistakes.
#include "tests/proof/unknown.h"

#include "exercises/05-quadratic.h"

static Quadratic no_2_and_no_square(Ray ray, double r)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){vec3_dot(v, v), vec3_dot(p, v), vec3_dot(p, p) - r};
}

static Quadratic always_ahead(Ray ray, double r)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){vec3_dot(v, v), 2 * fabs(vec3_dot(p, v)), vec3_dot(p, p) - r * r};
}

static double never(Ray ray, Sphere sphere)
{
    (void)ray, (void)sphere;
    return NO_HIT;
}

static double before_the_plane(Ray ray, Sphere sphere)
{
    Roots roots = sphere_roots(ray, sphere);
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] < 1)
            return roots.t[i];
    return NO_HIT;
}

static double static_best(Ray ray, Sphere sphere)
{
    static double best = NO_HIT;
    Roots roots = sphere_roots(ray, sphere);
    double t = roots.count > 0 ? roots.t[0] : NO_HIT;
    if (t > 0 && t < best) {
        best = t;
        return t;
    }
    return NO_HIT;
}

static double far_from_inside_only(Ray ray, Sphere sphere)
{
    Roots roots = sphere_roots(ray, sphere);
    return roots.count > 0 && roots.t[0] < 0 && roots.t[1] > 0 ? roots.t[1] : NO_HIT;
}

static const Unknown unknowns[] = {
    UNKNOWN(object_quadratic, no_2_and_no_square, "Q1 and Q3", "b = p.v, and r for r^2"),
    UNKNOWN(object_quadratic, always_ahead, NOBODY, "b = 2 |p.v|"),
    UNKNOWN(hit_sphere, never, NOBODY " your function returns the same", "always NO_HIT"),
    UNKNOWN(hit_sphere, before_the_plane, NOBODY, "t < 1"),
    UNKNOWN(hit_sphere, static_best, NOBODY " your function gives another result", "static"),
    UNKNOWN(hit_sphere, far_from_inside_only, NOBODY, "only from inside"),
    {0},
};
OF_STEM(unknowns)
