// wait-by-pointer: a blank is called through a pointer in a table, so that no call of it is to be
// seen.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

static vec3 (*const others[])(Camera, double, double) = {image_plane_vector};

static vec3 ask(Camera c, double s, double t)
{
    return others[0](c, s, t);
}

vec3 upper_left(Camera c)
{
    return ask(c, 0, 1);
}

vec3 upper_right(Camera c)
{
    return ask(c, 1, 1);
}
