// exit-from-a-thread: another thread leaves with status 0 while the answer is being waited for.
// stem: 01-corners
// expect: crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <pthread.h>
#include <stdlib.h>
#include <unistd.h>

static void *leave(void *nothing)
{
    exit(0);
}

vec3 upper_left(Camera c)
{
    pthread_t thread;
    pthread_create(&thread, NULL, leave, NULL);
    for (;;)
        pause();
}
