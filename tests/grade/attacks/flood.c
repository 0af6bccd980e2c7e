// flood: prints without end.
// stem: 01-corners
// expect: crashed | timed out
// earns: upper_right
// says: printed | still running | killed | by itself
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    for (;;)
        puts("forged-mark forged-mark forged-mark forged-mark forged-mark forged-mark");
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
