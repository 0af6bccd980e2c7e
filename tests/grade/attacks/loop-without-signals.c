// loop-without-signals: runs for ever, with every signal blocked and ignored.
// stem: 01-corners
// expect: timed out | crashed
// earns: upper_right
// says: still running | killed
#include "exercises/01-corners.h"
#include <signal.h>
#include <stddef.h>

vec3 upper_left(Camera c)
{
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, NULL);
    for (int i = 1; i < 65; i++)
        signal(i, SIG_IGN);
    for (volatile int i = 0;; i ^= 1)
        ;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
