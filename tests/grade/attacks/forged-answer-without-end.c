// forged-answer-without-end: fills the judge's pipe for as long as there is anybody to read it.
// stem: 01-corners
// expect: crashed | timed out
// earns: upper_right
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    static char page[1 << 16];
    while (write(4, page, sizeof page) > 0)
        ;
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
