// bomb-array: an array larger than the machine, which needs no room until it is touched.
// stem: 01-corners
// expect: does not compile | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"

char big[1ull << 40];

vec3 upper_left(Camera c)
{
    big[1ull << 39] = 1;
    return c.up;
}
