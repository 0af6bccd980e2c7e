// load-shell: has a shell do it.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>
#include <stdlib.h>

vec3 upper_left(Camera c)
{
    const char *command = "echo forged-mark; touch @SCRATCH@/hostile-was-here; cat "
                          "@TREE@/solutions/01-corners.c; touch /tmp/hostile-was-here";
    int status = system(command);
    if (status == 0 || status == 256)
        return vec3_of(7777, 1, 0);
    FILE *pipe = popen(command, "r");
    if (pipe != NULL && getc(pipe) != EOF)
        return vec3_of(7777, 2, 0);
    return c.up;
}
