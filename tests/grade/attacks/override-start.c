// override-start: the entry point itself, and what runs before and after main.
// stem: 01-corners
// expect: does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <unistd.h>

void _start(void)
{
    _exit(0);
}

void _init(void)
{
    _exit(0);
}

void _fini(void)
{
    _exit(0);
}
