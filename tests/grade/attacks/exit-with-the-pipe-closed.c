// exit-with-the-pipe-closed: closes every descriptor and waits, to see who waits longer.
// stem: 01-corners
// expect: crashed | timed out
// earns: upper_right
// says: closed its pipe | still running | was killed | no answer | by itself
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    for (int i = 0; i < 64; i++)
        close(i);
    for (;;)
        sleep(1);
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
