// override-by-alias: one function under many names, and other names for those asked for.
// stem: 01-corners
// expect: graded | does not compile | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"

static int yes(void)
{
    return 1;
}
int wire_is_read(void) __attribute__((alias("yes"), weak));
int memchr_(void) __asm__("memchr") __attribute__((alias("yes")));
#pragma weak fflush = yes

vec3 upper_left(Camera c)
{
    return c.up;
}
