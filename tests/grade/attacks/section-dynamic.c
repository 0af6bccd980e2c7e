// section-dynamic: entries for the loader: a library and a path of the student's.
// stem: 01-corners
// expect: crashed | graded | does not compile
// earns: perhaps upper_right
#include "exercises/01-corners.h"

__attribute__((section(".dynamic"), used)) static long entries[] = {15, 1, 29, 1, 0x6ffffefc, 1};
__asm__(".section .dynstr,\"a\",@progbits\n.asciz \"\\0/tmp/hostile-was-here.so\"\n.text\n");

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
