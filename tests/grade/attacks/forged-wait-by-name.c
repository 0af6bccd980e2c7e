// forged-wait-by-name: says that another's blank was called, which was not.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

#include "common/answers.h"

vec3 upper_left(Camera c)
{
    not_answered("upper_right", "x", &c, sizeof c);
    return c.up;
}

vec3 upper_right(Camera c)
{
    not_answered("hit_sphere", "x", &c, sizeof c);
    return c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    not_answered("with_unit_distance", "x", &c, sizeof c);
    return c.up;
}
