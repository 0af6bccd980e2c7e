// kill-group: its own group of processes, and its parent's.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <signal.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    if (getpgid(getppid()) > 1)
        kill(-getpgid(getppid()), SIGKILL);
    return c.up;
}

vec3 upper_right(Camera c)
{
    kill(0, SIGKILL);
    return c.up;
}
