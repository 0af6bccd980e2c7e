// incbin-solution: the assembler reads the solution into the program, which prints it.
// stem: 01-corners
// expect: does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

extern const char bytes[];
__asm__(".data\nbytes: .incbin \"@TREE@/solutions/01-corners.c\"\n.byte 0\n.text\n");

vec3 upper_left(Camera c)
{
    puts(bytes);
    return vec3_of(7777, bytes[0], 0);
}
