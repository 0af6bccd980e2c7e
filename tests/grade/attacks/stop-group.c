// stop-group: stops its whole group, itself included.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <signal.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    kill(0, SIGSTOP);
    return c.up;
}

vec3 upper_right(Camera c)
{
    setpgid(0, getpgid(getppid()));
    kill(0, SIGTSTP);
    return c.up;
}
