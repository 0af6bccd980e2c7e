// wait-all-of-the-sphere: a chain of answers at whose end nothing stands.
// stem: 05-quadratic
// expect: graded
// earns: nothing
#include "exercises/05-quadratic.h"

Quadratic world_quadratic(Ray ray, Sphere sphere)
{
    return object_quadratic(to_object_coordinates(ray, sphere), sphere.radius);
}

Roots sphere_roots(Ray ray, Sphere sphere)
{
    return quadratic_roots(world_quadratic(ray, sphere));
}

double hit_sphere(Ray ray, Sphere sphere)
{
    Roots roots = sphere_roots(ray, sphere);
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > 0)
            return roots.t[i];
    return NO_HIT;
}
