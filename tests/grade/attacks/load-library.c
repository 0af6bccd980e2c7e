// load-library: dlopen of what may lie about.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <dlfcn.h>
#include <stddef.h>

vec3 upper_left(Camera c)
{
    const char *names[] = {"@TREE@/build/judge/01-corners", "@TREE@/build/solutions/01-corners.o",
                           "/tmp/hostile-was-here.so", "libcheck.so", "libpng16.so.16"};
    for (int i = 0; i < 5; i++)
        if (dlopen(names[i], RTLD_NOW) != NULL)
            return vec3_of(7777, i, 0);
    return c.up;
}
