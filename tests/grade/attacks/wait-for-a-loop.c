// wait-for-a-loop: the first answer never ends, the second is made of it.
// stem: 01-corners
// expect: timed out
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    for (volatile int i = 0;; i ^= 1)
        ;
    return c.up;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}
