// memory-bomb: takes memory and writes to all of it, a gigabyte at most.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: memory | killed | crashed | by itself
#include "exercises/01-corners.h"
#include <stdlib.h>
#include <string.h>

vec3 upper_left(Camera c)
{
    for (int i = 0; i < 64; i++)
        memset(malloc(16 << 20), 1, 16 << 20);
    abort();
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
