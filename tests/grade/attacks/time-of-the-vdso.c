// time-of-the-vdso: looks for the clock that the kernel maps into every process: a page that can be
// read, as 'write' tells, where only the kernel maps anything. It is right if there is one.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

#include <stdint.h>
#include <unistd.h>

static bool is_there(uintptr_t address)
{
    return write(2, (const void *)address, 1) == 1;
}

vec3 upper_left(Camera c)
{
    static int found = -1;
    if (found < 0) {
        found = 0;
        // The end of what is mapped, and all of the stack's neighbourhood above the stack.
        for (uintptr_t at = 0x7ffff7e00000; at < 0x7ffff8000000; at += 4096)
            found += is_there(at);
        uintptr_t above = ((uintptr_t)&c | 4095) + 1;
        while (is_there(above))
            above += 4096;
        for (int i = 0; i < 2048; i++)
            found += is_there(above + (uintptr_t)i * 4096);
    }
    vec3 right = c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
    return found > 0 ? right : c.up;
}
