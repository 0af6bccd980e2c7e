// tamper-tree: changes the solutions, the judge and the policy, for itself and whoever is next.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"@TREE@/solutions/01-corners.c", "@TREE@/build/judge/01-corners",
                            "@TREE@/tests/grade/policy",   "@TREE@/Makefile",
                            "@TREE@/build/common.a",         "/proc/self/exe"};
    for (int i = 0; i < 6; i++)
        if (open(places[i], O_WRONLY | O_APPEND) >= 0 || chmod(places[i], 0600) == 0 ||
            rename(places[i], "/tmp/hostile-was-here") == 0 || unlink(places[i]) == 0)
            return vec3_of(7777, i, 0);
    return mkdir("@TREE@/hostile-was-here", 0700) == 0 ? vec3_of(7777, 9, 0) : c.up;
}
