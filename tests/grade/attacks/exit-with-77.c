// exit-with-77: the status by which test harnesses are told 'skipped'.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"
#include <stdlib.h>

vec3 upper_left(Camera c)
{
    exit(77);
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
