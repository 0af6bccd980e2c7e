// composed.c - answers to exercise 05 that call other answers of it.
#include "tests/proof/composed.h"

#include "solutions/05-quadratic.c"

SOLUTION(hit_sphere);

// As on the slides.
static Roots by_object(Ray ray, Sphere sphere)
{
    return quadratic_roots(object_quadratic(to_object_coordinates(ray, sphere), sphere.radius));
}

static Roots by_world(Ray ray, Sphere sphere)
{
    return quadratic_roots(world_quadratic(ray, sphere));
}

static double first_ahead(Roots roots)
{
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > 0)
            return roots.t[i];
    return NO_HIT;
}

static double hit_by_object(Ray ray, Sphere sphere)
{
    return first_ahead(by_object(ray, sphere));
}

static double hit_by_world(Ray ray, Sphere sphere)
{
    return first_ahead(by_world(ray, sphere));
}

static const Composed composed[] = {
    COMPOSED(sphere_roots, by_object),    COMPOSED(sphere_roots, by_world),
    COMPOSED(hit_sphere, own_hit_sphere), COMPOSED(hit_sphere, hit_by_object),
    COMPOSED(hit_sphere, hit_by_world),   {0},
};
OF_STEM(composed)

// Which mistake a mistake of the called function becomes in the caller.
static const SameMistake same_mistakes[] = {
    {"sphere_roots", "Q7", "Q7-roots"},
    {"sphere_roots", "O-unit", "S-unit"},
    {"sphere_roots", "R-plus-plain", "S-down"},
    {"sphere_roots", "R-plus-bare", "S-down in part"},
    {"sphere_roots", "R5", "R5-sphere"},
    {"sphere_roots", "R5-once", "S-once"},
    {"sphere_roots", "R-down", "S-down"},
    {"sphere_roots", "R-real", "S-always"},
    {"sphere_roots", "R-ahead", "S-ahead and S-inside"},
    {"sphere_roots", "Q7-world", "Q7-roots"},
    {"hit_sphere", "Q7-world", "Q7-hit"},
    {"hit_sphere", "Q1-world", "Q1-hit"},
    {"hit_sphere", "Q5-world", "Q5-hit"},
    {"hit_sphere", "R1", "R1-hit"},
    {"hit_sphere", "R-same", "R8"},
    {"hit_sphere", "R-plus-plain", "R6"},
    {"hit_sphere", "R-plus-bare", "R6"},
    {"hit_sphere", "R1-plain", "R1-hit"},
    {"hit_sphere", "R1-bare", "R1-hit"},
    {"hit_sphere", "R5", "R5-hit"},
    {"hit_sphere", "R-down", "R6"},
    {"hit_sphere", "Q7-roots", "Q7-hit"},
    {"hit_sphere", "S-unit", "T-way"},
    {"hit_sphere", "R5-sphere", "R5-hit"},
    {"hit_sphere", "S-down", "R6"},
    {"hit_sphere", "R-float", "T-float"},
    {"hit_sphere", "Q7", "Q7-hit"},
    {"hit_sphere", "O-unit", "T-way"},
    {"hit_sphere", "Q1", "Q1-hit"},
    {"hit_sphere", "Q5", "Q5-hit"},
    {0},
};
OF_STEM(same_mistakes)
