// override-main-weakly: a weak main, should no other be there.
// stem: 01-corners
// expect: graded
// earns: upper_right
#include "exercises/01-corners.h"
#include <stdio.h>

__attribute__((weak)) int main(void)
{
    puts("01-corners: 12 passed, 0 failed");
    return 0;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
