// mistakes.h - what the wrong answers to exercise 05 share.
#ifndef TESTS_05_QUADRATIC_MISTAKES_H
#define TESTS_05_QUADRATIC_MISTAKES_H

#include "exercises/05-quadratic.h"

#include "tests/judge/mistake.h"

extern const Mistake object_mistakes[], world_mistakes[], formula_mistakes[], plain_mistakes[],
    count_mistakes[], sphere_mistakes[], hit_mistakes[], root_limit_mistakes[], digit_mistakes[];

static const Roots no_roots = {0};

// The usual way to write it, with one slip. So it is right if a = 0.
static inline Roots line_root(Quadratic q)
{
    return q.b == 0 ? no_roots : (Roots){1, {-q.c / q.b}};
}

static inline Roots in_order(double t, double u)
{
    return t <= u ? (Roots){2, {t, u}} : (Roots){2, {u, t}};
}

static inline double discriminant(Quadratic q)
{
    return q.b * q.b - 4 * q.a * q.c;
}

// The formula of the slide: right, except for the digits that it loses.
static inline Roots slide(Quadratic q)
{
    double d = discriminant(q);
    if (q.a == 0)
        return line_root(q);
    if (d < 0)
        return no_roots;
    return in_order((-q.b - sqrt(d)) / (2 * q.a), (-q.b + sqrt(d)) / (2 * q.a));
}

static inline Roots slide_for_spheres(Ray ray, Sphere s)
{
    return slide(object_quadratic(to_object_coordinates(ray, s), s.radius));
}

#endif
