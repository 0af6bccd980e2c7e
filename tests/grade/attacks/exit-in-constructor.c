// exit-in-constructor: leaves with status 0 before main. It spoils its own honest work, too.
// stem: 01-corners
// expect: crashed
// earns: nothing
// says: by itself | was killed | no answer
#include "exercises/01-corners.h"
#include <unistd.h>

__attribute__((constructor(101))) static void leave(void)
{
    _exit(0);
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
