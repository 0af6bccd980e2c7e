// loop-before-main: runs for ever before main, in every process that is started of it.
// stem: 01-corners
// expect: timed out
// earns: nothing
// says: still running
#include "exercises/01-corners.h"

__attribute__((constructor)) static void begin(void)
{
    for (volatile int i = 0;; i ^= 1)
        ;
}
