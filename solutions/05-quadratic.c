// 05-quadratic.c - exercise 05: where a ray meets a sphere.
//
// Your answers go between BEGIN SOLUTION and END SOLUTION; helper functions may go anywhere.
// Questions and rules: exercises/05-quadratic.h. The lesson: chapters/05-quadratic/README.md.
// After each change:   make exercises EX=05
#include "exercises/05-quadratic.h"

#include "common/answers.h"

Ray to_object_coordinates(Ray ray, Sphere sphere)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Ray);
    return (Ray){ray.origin - sphere.center, ray.direction};
    // END SOLUTION
}

Quadratic object_quadratic(Ray object_ray, double radius)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Quadratic);
    vec3 p = object_ray.origin, v = object_ray.direction;
    return (Quadratic){vec3_dot(v, v), 2 * vec3_dot(p, v), vec3_dot(p, p) - radius * radius};
    // END SOLUTION
}

Quadratic world_quadratic(Ray ray, Sphere sphere)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Quadratic);
    vec3 p = ray.origin, v = ray.direction, c = sphere.center;
    return (Quadratic){vec3_dot(v, v), 2 * (vec3_dot(p, v) - vec3_dot(c, v)),
                       vec3_dot(p, p) - 2 * vec3_dot(p, c) + vec3_dot(c, c) -
                           sphere.radius * sphere.radius};
    // END SOLUTION
}

Roots quadratic_roots(Quadratic q)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Roots);
    if (q.a == 0)
        return q.b == 0 ? (Roots){0} : (Roots){1, {-q.c / q.b}};
    double D = q.b * q.b - 4 * q.a * q.c;
    if (!(D >= 0)) // also if it is not a number
        return (Roots){0};
    double t = (-q.b - sqrt(D)) / (2 * q.a), u = (-q.b + sqrt(D)) / (2 * q.a);
    return (Roots){2, {fmin(t, u), fmax(t, u)}};
    // END SOLUTION
}

Roots sphere_roots(Ray ray, Sphere sphere)
{
    // BEGIN SOLUTION
    //~ return quadratic_roots(
    //~     object_quadratic(to_object_coordinates(ray, sphere), sphere.radius));
    return quadratic_roots(object_quadratic(to_object_coordinates(ray, sphere), sphere.radius));
    // END SOLUTION
}

double hit_sphere(Ray ray, Sphere sphere)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(double);
    Roots roots = sphere_roots(ray, sphere);
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > 0)
            return roots.t[i];
    return NO_HIT;
    // END SOLUTION
}
