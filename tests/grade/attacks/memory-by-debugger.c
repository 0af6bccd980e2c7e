// memory-by-debugger: attaches to the judge as a debugger would.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <sys/ptrace.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    if (getppid() > 0 && ptrace(PTRACE_SEIZE, getppid(), 0, 0) == 0)
        return vec3_of(7777, 1, 0);
    if (getppid() > 0 && ptrace(PTRACE_ATTACH, getppid(), 0, 0) == 0)
        return vec3_of(7777, 2, 0);
    return c.up;
}
