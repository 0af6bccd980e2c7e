// override-clocks: stops time and chance: clock_gettime, poll, getrandom, alarm, waitpid.
// stem: 01-corners
// expect: timed out
// earns: nothing
// says: still running
#include "exercises/01-corners.h"
#include <time.h>

int clock_gettime(clockid_t clock, struct timespec *time)
{
    *time = (struct timespec){0};
    return 0;
}

long getrandom(void *bytes, size_t size, unsigned flags)
{
    return (long)size;
}

int poll(void *files, unsigned long count, int most)
{
    return 1;
}

vec3 upper_left(Camera c)
{
    for (volatile int i = 0;; i ^= 1)
        ;
}
