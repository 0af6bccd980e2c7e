// override-crash-handler: catches its own crash and goes on as if it had answered.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: upper_right
#include "exercises/01-corners.h"
#include <setjmp.h>
#include <signal.h>

static sigjmp_buf before;

static void back(int number)
{
    siglongjmp(before, 1);
}

vec3 upper_left(Camera c)
{
    signal(SIGSEGV, back);
    if (sigsetjmp(before, 1) == 0)
        *(volatile int *)8 = 1;
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
