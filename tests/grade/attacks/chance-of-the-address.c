// chance-of-the-address: a coin for every call, from where things lie and who one is.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdint.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    static uint64_t state;
    state =
        (state + (uintptr_t)&c + (uint64_t)getpid()) * 6364136223846793005u + 1442695040888963407u;
    double side = state >> 63 ? -0.5 : 0.5;
    return c.distance * c.forward + side * c.width * c.right + c.height / 2 * c.up;
}
