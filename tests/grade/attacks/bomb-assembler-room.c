// bomb-assembler-room: has the assembler write a terabyte of zeros.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
#include "exercises/01-corners.h"

__asm__(".data\n.fill 1000000000000, 1, 7\n.balign 1 << 30\n.quad 1\n.text\n");
