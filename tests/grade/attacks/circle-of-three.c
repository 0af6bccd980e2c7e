// circle-of-three: the same with three; any two of them are right, once the third is.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

static int depth;

vec3 upper_left(Camera c)
{
    vec3 v = depth++ < 3 ? image_plane_vector(c, 0, 1) : c.up;
    depth--;
    return v;
}

vec3 upper_right(Camera c)
{
    vec3 v = depth++ < 3 ? upper_left(c) + c.width * c.right : c.up;
    depth--;
    return v;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    vec3 v = depth++ < 3 ? upper_right(c) + (s - 1) * c.width * c.right + (t - 1) * c.height * c.up
                         : c.up;
    depth--;
    return v;
}
