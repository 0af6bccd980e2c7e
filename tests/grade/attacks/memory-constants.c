// memory-constants: writes into what is read-only.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: write to address | crashed | killed
#include "exercises/01-corners.h"

static const double zero[2];

vec3 upper_left(Camera c)
{
    *(volatile double *)&zero[1] = 1;
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
