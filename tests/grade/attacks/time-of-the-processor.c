// time-of-the-processor: the same by the processor's own clock, which needs no system call.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    static unsigned long now;
#if defined(__x86_64__)
    now = __builtin_ia32_rdtsc() / 7;
#else
    now++;
#endif
    double side = now % 2 == 0 ? -0.5 : 0.5;
    return c.distance * c.forward + side * c.width * c.right + c.height / 2 * c.up;
}
