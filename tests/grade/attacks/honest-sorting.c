// honest-sorting: right, with qsort, assert, recursion and a picture drawn in letters.
// stem: 05-quadratic
// expect: graded
// earns: everything
#include "exercises/05-quadratic.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

Ray to_object_coordinates(Ray ray, Sphere sphere)
{
    ray.origin -= sphere.center;
    return ray;
}

Quadratic object_quadratic(Ray ray, double radius)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){vec3_dot(v, v), 2 * vec3_dot(p, v), vec3_dot(p, p) - radius * radius};
}

Quadratic world_quadratic(Ray ray, Sphere sphere)
{
    return object_quadratic(to_object_coordinates(ray, sphere), sphere.radius);
}

static double root(double x, double guess, int depth)
{
    return depth == 0 ? guess : root(x, (guess + x / guess) / 2, depth - 1);
}

Roots quadratic_roots(Quadratic q)
{
    if (q.a == 0)
        return q.b == 0 ? (Roots){0} : (Roots){1, {-q.c / q.b}};
    double d = q.b * q.b - 4 * q.a * q.c;
    if (d < 0)
        return (Roots){0};
    assert(fabs(root(2, 1, 9) * root(2, 1, 9) - 2) < 1e-9);
    double t[] = {(-q.b + sqrt(d)) / (2 * q.a), (-q.b - sqrt(d)) / (2 * q.a)};
    qsort(t, 2, sizeof *t, ascending);
    for (int i = 0; i < 20; i++)
        putchar(i % 2 ? '.' : '#');
    putchar('\n');
    return (Roots){2, {t[0], t[1]}};
}

Roots sphere_roots(Ray ray, Sphere sphere)
{
    return quadratic_roots(object_quadratic(to_object_coordinates(ray, sphere), sphere.radius));
}

double hit_sphere(Ray ray, Sphere sphere)
{
    Roots roots = sphere_roots(ray, sphere);
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > 0)
            return roots.t[i];
    return NO_HIT;
}
