// memory-everything: prints all of its own memory, and what descriptors were left open.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

extern char __bss_start[], _end[], __executable_start[];

vec3 upper_left(Camera c)
{
    static char page[4096];
    if (write(1, __executable_start, 1 << 14) < 0 || write(1, __bss_start, 1 << 10) < 0)
        return c.right;
    for (int i = 5; i < 1024; i++)
        if (fcntl(i, F_GETFD) >= 0)
            return vec3_of(7777, i, pread(i, page, sizeof page, 0) > 0);
    return c.up;
}
