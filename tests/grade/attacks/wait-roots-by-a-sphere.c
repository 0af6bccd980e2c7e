// wait-roots-by-a-sphere: roots of an equation by a sphere that has it, with the two questions
// after it blank.
// stem: 05-quadratic
// expect: graded
// earns: nothing
#include "exercises/05-quadratic.h"

Roots quadratic_roots(Quadratic q)
{
    vec3 v = vec3_of(sqrt(q.a), 0, 0), p = vec3_of(q.b / (2 * sqrt(q.a)), 0, 0);
    double r = sqrt(vec3_dot(p, p) - q.c);
    return sphere_roots((Ray){p, v}, (Sphere){.radius = r});
}

Ray to_object_coordinates(Ray ray, Sphere sphere)
{
    double t = hit_sphere(ray, sphere);
    ray.origin += 0 * t * ray.direction;
    return ray;
}
