// honest-output: right, and talks a lot: 20 kB for every call, with escape codes and a bell.
// stem: 01-corners
// expect: graded
// earns: upper_right
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_right(Camera c)
{
    for (int i = 0; i < 1000; i++)
        printf("\x1b[31mforged-mark %d\x1b[0m\a\r\n", i);
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
