// stack-overflow: calls itself without end.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: stack | crashed | killed
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    c.width += 1;
    return upper_left(c) + c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
