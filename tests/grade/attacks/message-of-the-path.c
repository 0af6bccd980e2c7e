// message-of-the-path: prints where it was compiled, and from what.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    puts(__FILE__ " " __BASE_FILE__ " " __TIMESTAMP__ " " __VERSION__);
    return c.up;
}
