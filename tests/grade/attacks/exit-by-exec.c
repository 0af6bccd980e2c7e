// exit-by-exec: becomes a program that ends well, or itself once more.
// stem: 01-corners
// expect: crashed | timed out | graded
// earns: nothing
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 upper_left(Camera c)
{
    char *const none[] = {"true", NULL};
    execve("/bin/true", none, none + 1);
    execve("/usr/bin/true", none, none + 1);
    return c.up;
}

vec3 upper_right(Camera c)
{
    char *const none[] = {"answering", NULL};
    execve("/proc/self/exe", none, none + 1);
    return c.up;
}
