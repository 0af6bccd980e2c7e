// bomb-assembler: repeats a line for the assembler a thousand million times.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
#include "exercises/01-corners.h"

__asm__(".data\n.rept 1000000000\n.quad 1, 2, 3, 4\n.endr\n.text\n");
