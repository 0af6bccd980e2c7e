// assembler-include: .include, whose complaints quote what was read.
// stem: 01-corners
// expect: does not compile
// earns: nothing
#include "exercises/01-corners.h"

__asm__(".include \"@TREE@/solutions/01-corners.c\"\n.include \"/proc/self/environ\"\n"
        ".include \"/etc/passwd\"\n");
