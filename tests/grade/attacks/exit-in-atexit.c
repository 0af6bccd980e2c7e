// exit-in-atexit: wrong answers, and a handler that turns any end into status 0.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static void all_is_well(void)
{
    puts("100%: Checks: 12, Failures: 0, Errors: 0");
    fflush(stdout);
    _exit(0);
}

vec3 upper_left(Camera c)
{
    atexit(all_is_well);
    at_quick_exit(all_is_well);
    return c.up;
}
