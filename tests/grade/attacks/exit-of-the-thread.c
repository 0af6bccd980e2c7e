// exit-of-the-thread: ends the only thread, and with it the process, with status 0.
// stem: 01-corners
// expect: crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <pthread.h>
#include <threads.h>

vec3 upper_left(Camera c)
{
    pthread_exit(NULL);
}

vec3 upper_right(Camera c)
{
    thrd_exit(0);
}
