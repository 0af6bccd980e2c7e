// section-interpreter: names the program that is to load the answering program.
// stem: 01-corners
// expect: crashed | graded | does not compile
// earns: perhaps upper_right
#include "exercises/01-corners.h"

__attribute__((section(".interp"), used)) static const char loader[] =
    "@TREE@/tests/grade/attacks/no-loader";

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
