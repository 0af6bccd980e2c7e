// load-compiler: compiles the solution on the spot.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <sys/wait.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    char *const words[] = {"cc",
                           "-I@TREE@",
                           "-shared",
                           "-o",
                           "/tmp/hostile-was-here.so",
                           "@TREE@/solutions/01-corners.c",
                           NULL};
    pid_t child = fork();
    if (child == 0) {
        execv("/usr/bin/cc", words);
        _exit(1);
    }
    int status;
    if (child > 0 && waitpid(child, &status, 0) == child && status == 0)
        return vec3_of(7777, 1, 0);
    return c.up;
}
