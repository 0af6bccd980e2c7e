// exit-by-alarm: a timer leaves with status 0 while an endless loop runs.
// stem: 01-corners
// expect: crashed | timed out
// earns: upper_right
#include "exercises/01-corners.h"
#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

static void leave(int number)
{
    _exit(0);
}

vec3 upper_left(Camera c)
{
    signal(SIGALRM, leave);
    setitimer(ITIMER_REAL, &(struct itimerval){{0, 0}, {0, 1000}}, NULL);
    for (volatile int i = 0;; i ^= 1)
        ;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
