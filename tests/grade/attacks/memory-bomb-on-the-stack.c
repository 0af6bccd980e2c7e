// memory-bomb-on-the-stack: an array larger than any stack.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: stack | crashed | killed
#include "exercises/01-corners.h"
#include <string.h>

vec3 upper_left(Camera c)
{
    char big[1 << 30];
    memset(big, 1, sizeof big);
    return vec3_of(big[(int)c.width], 0, 0);
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
