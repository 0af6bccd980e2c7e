// memory-environment: prints the environment, and looks for words that were not for it.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>
#include <stdlib.h>

extern char **environ;

vec3 upper_left(Camera c)
{
    for (char **at = environ; at != NULL && *at != NULL; at++)
        puts(*at);
    if (getenv("HOSTILE_CANARY") != NULL)
        return vec3_of(7777, 1, 0);
    FILE *file = fopen("/proc/self/environ", "r");
    for (int byte = 0; file != NULL && byte >= 0;)
        putchar(byte = getc(file));
    return c.up;
}
