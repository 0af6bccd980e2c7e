// override-by-version: takes the C library's write by its version, from the assembler.
// stem: 01-corners
// expect: graded | timed out | crashed | does not compile
// earns: nothing
#include "exercises/01-corners.h"

__asm__(".globl write\n.globl poll\nwrite:\npoll:\n ret\n");
long mine(void)
{
    return 0;
}
__asm__(".symver mine,write@GLIBC_2.2.5");

vec3 upper_left(Camera c)
{
    return c.up;
}
