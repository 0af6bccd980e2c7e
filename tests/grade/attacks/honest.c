// honest.c - not attacks: honest answers that look like some, and must keep their marks.

// ---- honest-counting: right, by a table that it fills itself, and a loop.
// -> graded; earns everything
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
// -> graded; earns upper_right
vec3 upper_right(Camera c)
{
    for (int i = 0; i < 1000; i++)
        printf("\x1b[31mforged-mark %d\x1b[0m\a\r\n", i);
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

// ---- honest-pragma: right, and optimised as its author thinks best. Warnings are its own concern.
// -> graded; earns upper_left upper_right
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
// -> graded; of 05-quadratic; earns everything
#include <assert.h>

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
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

// ---- honest-wait: made of an answer that is wrong in a known way. It is right once that one is.
// -> graded; earns upper_right across_30_up_10
vec3 upper_left(Camera c)
{
    return c.distance * c.forward - c.width / 2 * c.right - c.height / 2 * c.up;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return c.distance * c.forward + (0.5 - s) * c.width * c.right + (t - 0.5) * c.height * c.up;
}

// ---- honest-wrong: the whole width for the half of it; what is made of it waits; the rest is
// blank.
// -> graded; earns across_30_up_10 upper_right
vec3 upper_left(Camera c)
{
    return c.distance * c.forward - c.width * c.right + c.height * c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return c.distance * c.forward + s * c.width * c.right + t * c.height * c.up;
}
