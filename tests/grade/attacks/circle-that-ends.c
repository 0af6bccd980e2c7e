// circle-that-ends: the same, without a crash: the second time round it gives up.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

static int depth;

vec3 upper_left(Camera c)
{
    vec3 v = depth++ < 2 ? upper_right(c) - c.width * c.right : c.up;
    depth--;
    return v;
}

vec3 upper_right(Camera c)
{
    vec3 v = depth++ < 2 ? upper_left(c) + c.width * c.right : c.up;
    depth--;
    return v;
}
