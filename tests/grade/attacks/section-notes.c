// section-notes: forged notes: a stack that may be run, processor features, a build id.
// stem: 01-corners
// expect: graded | crashed | does not compile
// earns: perhaps upper_right
#include "exercises/01-corners.h"

__asm__(".section .note.gnu.property,\"a\",@note\n.long 4, 16, 5\n.asciz \"GNU\"\n"
        ".long 0xc0000002, 4, 0xffffffff, 0\n"
        ".section .note.gnu.build-id,\"a\",@note\n.long 4, 4, 3\n.asciz \"GNU\"\n.long 0\n"
        ".section .note.GNU-stack,\"x\",@progbits\n.text\n");

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
