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
    return NOT_ANSWERED(Ray);
    // END SOLUTION
}

Quadratic object_quadratic(Ray object_ray, double radius)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Quadratic);
    // END SOLUTION
}

Quadratic world_quadratic(Ray ray, Sphere sphere)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Quadratic);
    // END SOLUTION
}

Roots quadratic_roots(Quadratic q)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Roots);
    // END SOLUTION
}

Roots sphere_roots(Ray ray, Sphere sphere)
{
    // BEGIN SOLUTION
    return quadratic_roots(
        object_quadratic(to_object_coordinates(ray, sphere), sphere.radius));
    // END SOLUTION
}

double hit_sphere(Ray ray, Sphere sphere)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(double);
    // END SOLUTION
}
