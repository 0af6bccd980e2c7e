// lend-very-often: asks the judge for what it lends, again and again.
// stem: 01-corners
// expect: timed out | graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    if (vec3_length(upper_right(camera_of_the_deck()) - vec3_of(1, 1, 4)) < 1e-9)
        for (;;)
            upper_right(c);
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.right;
}
