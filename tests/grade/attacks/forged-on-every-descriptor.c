// forged-on-every-descriptor: says 'right' on all of 0 to 63, the judge's pipes among them.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: no answer | was killed | by itself
#include "exercises/01-corners.h"
#include <string.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const char *words = "upper_left right forged-mark\n";
    for (int i = 0; i < 64; i++)
        for (int j = 0; j < 9; j++)
            if (write(i, words, strlen(words)) < 0)
                break;
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
