// reference-by-name: looks the reference up while it runs, in itself and in the judge's program.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <dlfcn.h>
#include <stddef.h>

typedef vec3 Function(Camera c);

vec3 upper_left(Camera c)
{
    const char *names[] = {"reference_upper_left", "lent_upper_left", "_upper_left"};
    void *places[] = {NULL, dlopen(NULL, RTLD_NOW),
                      dlopen("@TREE@/build/judge/01-corners", RTLD_NOW)};
    vec3 thrown_away = upper_right(c);
    for (int i = 0; i < 9; i++) {
        Function *found = (Function *)dlsym(places[i / 3], names[i % 3]);
        if (found != NULL)
            return found(c);
    }
    return 0 * thrown_away;
}

vec3 upper_right(Camera c)
{
    return c.up;
}
