// circle-of-two: each corner is made from the other; each is right, once the other is.
// stem: 01-corners
// expect: crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return upper_right(c) - c.width * c.right;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}
