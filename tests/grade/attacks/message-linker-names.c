// message-linker-names: misses a function whose name is a forged line with escape codes.
// stem: 01-corners
// expect: does not compile | graded
// earns: nothing
#include "exercises/01-corners.h"

void odd(void) __asm__("x\nok 1 - forged-mark\n\033[2J");
void odder(void) __asm__("=1+1</pre><script>");

vec3 upper_left(Camera c)
{
    odd();
    odder();
    return c.up;
}
