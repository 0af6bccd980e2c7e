// exit-abort: aborts, with SIGABRT ignored and blocked first.
// stem: 01-corners
// expect: crashed
// earns: upper_right
// says: aborted | by itself | was killed | crashed
#include "exercises/01-corners.h"
#include <signal.h>
#include <stdlib.h>

vec3 upper_left(Camera c)
{
    signal(SIGABRT, SIG_IGN);
    abort();
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
