// exit-at-once: _exit(0), which runs no handler and flushes nothing.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    _exit(0);
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
