// loop: runs for ever.
// stem: 01-corners
// expect: timed out
// earns: upper_right
// says: still running
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    for (volatile int i = 0;; i ^= 1)
        ;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
