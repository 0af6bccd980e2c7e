// circle-of-chapters: chapter 05 in a ring: roots from the sphere, the sphere from roots.
// stem: 05-quadratic
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/05-quadratic.h"

static int depth;

Quadratic object_quadratic(Ray ray, double radius)
{
    depth++;
    Quadratic q = depth < 4 ? world_quadratic(ray, (Sphere){.radius = radius}) : (Quadratic){0};
    depth--;
    return q;
}

Quadratic world_quadratic(Ray ray, Sphere sphere)
{
    depth++;
    Ray moved = {ray.origin - sphere.center, ray.direction};
    Quadratic q = depth < 4 ? object_quadratic(moved, sphere.radius) : (Quadratic){0};
    depth--;
    return q;
}
