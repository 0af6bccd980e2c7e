// read-the-pipe: eats the judge's next call, and waits for the one behind it.
// stem: 01-corners
// expect: timed out | crashed
// earns: upper_right
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    char bytes[64];
    while (read(3, bytes, sizeof bytes) > 0)
        ;
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
