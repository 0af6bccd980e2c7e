// daemon: a grandchild in a session of its own, which outlives its parents by a minute.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    if (fork() == 0) {
        setsid();
        if (fork() == 0)
            sleep(60);
        _exit(0);
    }
    return c.up;
}
