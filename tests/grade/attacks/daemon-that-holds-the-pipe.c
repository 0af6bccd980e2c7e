// daemon-that-holds-the-pipe: the process ends, and its child keeps the judge's pipe open.
// stem: 01-corners
// expect: crashed | timed out | graded
// earns: nothing
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    pid_t child = fork();
    if (child == 0) {
        setsid();
        sleep(60);
        _exit(0);
    }
    if (child > 0)
        _exit(0);
    return c.up;
}
