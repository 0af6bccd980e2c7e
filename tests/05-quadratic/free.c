// free.c - right answers by the formulas of the slides, which round differently from the reference.
#include "exercises/05-quadratic.h"

Ray to_object_coordinates(Ray ray, Sphere sphere)
{
    return (Ray){ray.origin - sphere.center, ray.direction};
}

Quadratic object_quadratic(Ray object_ray, double radius)
{
    vec3 p = object_ray.origin, v = object_ray.direction;
    double distance = vec3_length(p);
    return (Quadratic){vec3_dot(v, v), 2 * vec3_dot(p, v),
                       (distance - radius) * (distance + radius)};
}

Quadratic world_quadratic(Ray ray, Sphere sphere)
{
    return object_quadratic(to_object_coordinates(ray, sphere), sphere.radius);
}

Roots quadratic_roots(Quadratic q)
{
    if (q.a == 0)
        return q.b == 0 ? (Roots){.count = 0} : (Roots){1, {-q.c / q.b}};
    double d = q.b * q.b - 4 * q.a * q.c;
    if (d < 0)
        return (Roots){.count = 0};
    double t = (-q.b - sqrt(d)) / (2 * q.a), u = (-q.b + sqrt(d)) / (2 * q.a);
    return t <= u ? (Roots){2, {t, u}} : (Roots){2, {u, t}};
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
