// many-files: a hundred of them, and every descriptor that there is.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    char name[64];
    int made = 0;
    for (int i = 0; i < 100; i++) {
        snprintf(name, sizeof name, "/tmp/hostile-was-here-%d", i);
        made += mkdir(name, 0700) == 0;
    }
    while (dup(1) >= 0)
        ;
    return made > 0 ? vec3_of(7777, made, 0) : c.up;
}
