// forged-tap: TAP lines on stdout and stderr, with a plan, a bail-out and escape codes.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    for (int i = 1; i < 4; i++)
        fprintf(i < 3 ? stdout : stderr, "TAP version 14\n1..1\nok 1 - forged-mark\nBail out! "
                                         "forged-mark\x1b[2J\x1b]0;forged-mark\x07\n");
    return c.up;
}
