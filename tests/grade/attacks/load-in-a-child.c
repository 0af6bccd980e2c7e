// load-in-a-child: vfork and posix_spawn, for filters that only know fork.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <spawn.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    char *const words[] = {"sh", "-c", "touch /tmp/hostile-was-here", NULL};
    pid_t child;
    if (posix_spawn(&child, "/bin/sh", NULL, NULL, words, words + 3) == 0)
        return vec3_of(7777, 1, 0);
    child = vfork();
    if (child == 0)
        _exit(0);
    return child > 0 ? vec3_of(7777, 2, 0) : c.up;
}
