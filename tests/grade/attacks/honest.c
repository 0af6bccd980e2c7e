// honest.c - not attacks: honest answers that look like some, and must keep their marks.
// cases.py reads it: each section is one submission, and states the result that it must get.

// ---- honest-counting: right, by a table that it fills itself, and a loop.
// stem: 01-corners
// expect: graded
// earns: everything
#include "exercises/01-corners.h"
#include <stdio.h>
#include <stdlib.h>

static const double signs[][2] = {{-0.5, 0.5}, {0.5, 0.5}};

static vec3 sum(Camera c, const double weights[3])
{
    vec3 *parts = malloc(3 * sizeof *parts), total = {0};
    parts[0] = c.forward, parts[1] = c.right, parts[2] = c.up;
    for (int i = 0; i < 3; i++)
        total += weights[i] * parts[i];
    free(parts);
    return total;
}

vec3 upper_left(Camera c)
{
    printf("upper_left, d %g\n", c.distance);
    return sum(c, (double[]){c.distance, signs[0][0] * c.width, signs[0][1] * c.height});
}

vec3 upper_right(Camera c)
{
    fprintf(stderr, "upper_right, d %g\n", c.distance);
    return sum(c, (double[]){c.distance, signs[1][0] * c.width, signs[1][1] * c.height});
}

vec3 across_30_up_10(Camera c)
{
    return image_plane_vector(c, 0.3, 0.1);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return sum(c, (double[]){c.distance, (s - 0.5) * c.width, (t - 0.5) * c.height});
}

Camera with_unit_distance(Camera c)
{
    Camera *other = calloc(1, sizeof *other);
    *other = c;
    other->width /= c.distance;
    other->height /= c.distance;
    other->distance = 1;
    Camera answer = *other;
    free(other);
    return answer;
}

// ---- honest-output: right, and talks a lot: 20 kB for every call, with escape codes and a bell.
// stem: 01-corners
// expect: graded
// earns: upper_right
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_right(Camera c)
{
    for (int i = 0; i < 1000; i++)
        printf("\x1b[31mforged-mark %d\x1b[0m\a\r\n", i);
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- honest-pragma: right, and optimised as its author thinks best. Warnings are its own concern.
// stem: 01-corners
// expect: graded
// earns: upper_left upper_right
#pragma GCC optimize("O3")
#include "exercises/01-corners.h"
#include <complex.h>
#include <string.h>

vec3 upper_left(Camera c)
{
    int unused;
    return c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
}

__attribute__((noinline, optimize("O2"))) vec3 upper_right(Camera c)
{
    char words[100];
    memset(words, 'x', sizeof words);
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- honest-sorting: right, with qsort, assert, recursion and a picture drawn in letters.
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

// ---- honest-wait: made of an answer that is wrong in a known way. It is right once that one is.
// stem: 01-corners
// expect: graded
// earns: upper_right across_30_up_10
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.distance * c.forward - c.width / 2 * c.right - c.height / 2 * c.up;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}

vec3 across_30_up_10(Camera c)
{
    return image_plane_vector(c, 0.3, 0.1);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return c.distance * c.forward + (0.5 - s) * c.width * c.right + (t - 0.5) * c.height * c.up;
}

// ---- honest-wrong: the whole width for the half of it; what is made of it waits; the rest is blank.
// stem: 01-corners
// expect: graded
// earns: across_30_up_10 upper_right
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.distance * c.forward - c.width * c.right + c.height * c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

vec3 across_30_up_10(Camera c)
{
    return image_plane_vector(c, 0.3, 0.1);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return c.distance * c.forward + s * c.width * c.right + t * c.height * c.up;
}
