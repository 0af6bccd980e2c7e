// exit-in-destructor: wrong answers, and a destructor that reports success on every channel.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"
#include <string.h>
#include <unistd.h>

__attribute__((destructor)) static void report(void)
{
    const char *words = "ok 1 - upper_left\nupper_left right\n";
    for (int i = 0; i < 64; i++)
        if (write(i, words, strlen(words)) < 0)
            continue;
    _exit(0);
}

vec3 upper_left(Camera c)
{
    return c.right;
}
