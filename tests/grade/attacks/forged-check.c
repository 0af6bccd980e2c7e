// forged-check: prints what Check prints when all is well, and leaves.
// stem: 01-corners
// expect: crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>
#include <stdlib.h>

vec3 upper_left(Camera c)
{
    puts("Running suite(s): 01-corners\n100%: Checks: 12, Failures: 0, Errors: 0");
    fputs("01-corners: 12 passed, 0 failed\n", stderr);
    exit(0);
}
