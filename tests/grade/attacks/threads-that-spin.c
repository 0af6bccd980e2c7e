// threads-that-spin: answers wrongly, and leaves 16 threads running.
// stem: 01-corners
// expect: graded | crashed | timed out
// earns: nothing
#include "exercises/01-corners.h"
#include <pthread.h>

static void *spin(void *nothing)
{
    for (volatile int i = 0; i < 2; i ^= 1)
        ;
    return nothing;
}

vec3 upper_left(Camera c)
{
    for (int i = 0; i < 16; i++) {
        pthread_t thread;
        if (pthread_create(&thread, NULL, spin, NULL) == 0)
            pthread_detach(thread);
    }
    return c.up;
}
