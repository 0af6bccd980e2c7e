// kill-by-limits: takes memory, files and processor time from its parent.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const struct rlimit none = {1, 1};
    if (getppid() > 1)
        for (int i = 0; i < 16; i++)
            if (syscall(SYS_prlimit64, getppid(), i, &none, NULL) == 0)
                return vec3_of(7777, i, 0);
    return c.up;
}
