// stop-parent: stops who waits for it, so that nobody's time runs out.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <signal.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    if (getppid() > 1 && kill(getppid(), SIGSTOP) == 0)
        for (;;)
            sleep(1);
    return c.up;
}
