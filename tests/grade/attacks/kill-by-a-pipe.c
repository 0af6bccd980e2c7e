// kill-by-a-pipe: asks for a signal whenever the pipe has news, and names its parent to get it.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    for (int i = 0; i < 5; i++) {
        if (getppid() > 1 && fcntl(i, F_SETOWN, getppid()) == 0 &&
            fcntl(i, 10 /* F_SETSIG */, SIGKILL) == 0)
            fcntl(i, F_SETFL, O_ASYNC | O_NONBLOCK);
    }
    return c.up;
}
