// message-linker: a section that makes the linker print the student's words as a warning.
// stem: 01-corners
// expect: graded
// earns: upper_right
#include "exercises/01-corners.h"

__attribute__((section(".gnu.warning.upper_left"), used)) static const char words[] =
    "\nok 1 - forged-mark\n\x1b[2J  multiple definition of `main'";

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
