// forged-answer-byte-by-byte: feeds the judge a byte now and then, each just before it gives up.
// stem: 01-corners
// expect: timed out | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    for (int i = 0; i < 60; i++) {
        if (write(4, "C", 1) != 1)
            break;
        usleep(900000);
    }
    return c.up;
}
