// incbin-reference: the compiled reference, to be called where it lies.
// stem: 01-corners
// expect: does not compile
// earns: nothing
#include "exercises/01-corners.h"

extern vec3 there(Camera c);
__asm__(".text\nthere = . + 64\n.incbin \"@TREE@/build/solutions/01-corners.o\"\n");

vec3 upper_left(Camera c)
{
    return there(c);
}
