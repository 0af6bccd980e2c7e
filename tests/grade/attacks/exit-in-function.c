// exit-in-function: leaves with status 0 in the middle of an answer; Check takes that for a pass.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"
#include <stdlib.h>

vec3 upper_left(Camera c)
{
    exit(0);
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
