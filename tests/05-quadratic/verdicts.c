// verdicts.c - wrong answers to exercise 05 that are not known mistakes, and the verdict on each.
#include "exercises/05-quadratic.h"

#include "tests/judge/known.h"

UNNAMED(object_quadratic, "Q1 and Q3", "b = p.v, and r for r^2")
{
    vec3 p = object_ray.origin, v = object_ray.direction;
    return (Quadratic){vec3_dot(v, v), vec3_dot(p, v), vec3_dot(p, p) - radius};
}

UNNAMED(object_quadratic, NOBODY, "b = 2 |p.v|")
{
    vec3 p = object_ray.origin, v = object_ray.direction;
    return (Quadratic){vec3_dot(v, v), 2 * fabs(vec3_dot(p, v)), vec3_dot(p, p) - radius * radius};
}

UNNAMED_LINE(hit_sphere, NOBODY " your function returns the same", "always NO_HIT", return NO_HIT)

UNNAMED(hit_sphere, NOBODY, "t < 1")
{
    Roots roots = sphere_roots(ray, sphere);
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] < 1)
            return roots.t[i];
    return NO_HIT;
}

UNNAMED(hit_sphere, NOBODY " your function gives another result", "static")
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

UNNAMED(hit_sphere, NOBODY, "only from inside")
{
    Roots roots = sphere_roots(ray, sphere);
    return roots.count > 0 && roots.t[0] < 0 && roots.t[1] > 0 ? roots.t[1] : NO_HIT;
}
