// wait-normal-by-step: a normal from where a ray starts that leaves the surface, which is later
// and blank.
// stem: 07-shading
// expect: graded
// earns: nothing
#include "exercises/07-shading.h"

vec3 surface_normal(Sphere sphere, vec3 point)
{
    vec3 step = off_surface(sphere, point, vec3_of(0, 0, 1)) - point;
    return vec3_unit(point - sphere.center + 0 * step);
}
