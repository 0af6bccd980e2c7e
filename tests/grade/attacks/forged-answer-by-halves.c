// forged-answer-by-halves: half a header, then nothing more, so that the judge waits for ever.
// stem: 01-corners
// expect: timed out | crashed
// earns: upper_right
// says: still running | no answer | never comes
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    if (write(4, "CyaR\0\0\0", 8) == 8)
        for (;;)
            pause();
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
