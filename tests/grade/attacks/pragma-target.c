// pragma-target: code for another processor, which passes a vec3 in another way.
// stem: 01-corners
// expect: graded | crashed | does not compile
// earns: nothing
#if defined(__x86_64__)
#pragma GCC target("avx512f")
#endif
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.up * 2.5;
}
