// exit-by-longjmp: jumps back into a call that is over, to leave the judge's loop sideways.
// stem: 01-corners
// expect: crashed | timed out | graded
// earns: nothing
#include "exercises/01-corners.h"
#include <setjmp.h>
#include <signal.h>

static jmp_buf before;
static volatile int calls;

static void back(int number)
{
    longjmp(before, 1);
}

vec3 upper_left(Camera c)
{
    signal(SIGSEGV, back);
    if (calls++ == 0 && setjmp(before) != 0)
        return c.up;
    if (calls > 1)
        longjmp(before, 1);
    return c.right;
}

vec3 upper_right(Camera c)
{
    longjmp(before, 1);
}
