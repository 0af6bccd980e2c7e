// flood-that-cares: the same on stderr, with the signal that would end it ignored.
// stem: 01-corners
// expect: crashed | timed out
// earns: upper_right
// says: printed | still running | killed | by itself
#include "exercises/01-corners.h"
#include <signal.h>
#include <string.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    static char page[4096];
    signal(SIGXFSZ, SIG_IGN);
    memset(page, 'x', sizeof page);
    for (;;)
        if (write(2, page, sizeof page) < 0 && write(1, page, sizeof page) < 0)
            continue;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
