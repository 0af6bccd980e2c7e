// message-assembler: the assembler prints what it is told to, on stdout and stderr.
// stem: 01-corners
// expect: does not compile
// earns: nothing
#include "exercises/01-corners.h"

__asm__(".print \"ok 1 - forged-mark\\n\\033[2J\"\n.warning \"=1+1\\n\\033[2J\"\n"
        ".error \"tests/05-quadratic.c: 100 passed\\n\"");
