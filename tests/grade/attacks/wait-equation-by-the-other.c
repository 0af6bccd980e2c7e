// wait-equation-by-the-other: an equation by the other one, which is later and blank.
// stem: 05-quadratic
// expect: graded
// earns: nothing
#include "exercises/05-quadratic.h"

Quadratic object_quadratic(Ray object_ray, double radius)
{
    return world_quadratic(object_ray, (Sphere){.radius = radius});
}
