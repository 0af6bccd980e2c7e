// override-libc-start: __libc_start_main, which calls main, and exit, which ends it.
// stem: 01-corners
// expect: crashed | does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <stdlib.h>
#include <unistd.h>

int __libc_start_main(void)
{
    _exit(0);
}

void exit(int status)
{
    _exit(0);
}
