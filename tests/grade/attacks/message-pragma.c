// message-pragma: the compiler prints a string of the student's, newlines and escape codes included.
// stem: 01-corners
// expect: graded
// earns: upper_right
#include "exercises/01-corners.h"
#pragma message "x\ntests/05-quadratic.c:1: 100 passed forged-mark\n\x1b[2J\033]0;x\a=1+1"
#warning =1+1 </pre><script>
_Pragma("GCC warning \"\\nok 1 - all\\n\\033[2J\"")

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
