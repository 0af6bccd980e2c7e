// fork-bomb: doubles itself, ten times at most, and each of them lives for 20 seconds.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <stdlib.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    pid_t me = getpid();
    for (int i = 0; i < 10; i++)
        if (fork() > 0)
            continue;
    if (getpid() == me)
        return c.up;
    alarm(20);
    for (;;)
        pause();
}
