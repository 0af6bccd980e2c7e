// honest-pragma: right, and optimised as its author thinks best. Warnings are its own concern.
// stem: 01-corners
// expect: graded
// earns: upper_left upper_right
#pragma GCC optimize("O3")
#include "exercises/01-corners.h"
#include <complex.h>
#include <string.h>

vec3 upper_left(Camera c)
{
    int unused;
    return c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
}

__attribute__((noinline, optimize("O2"))) vec3 upper_right(Camera c)
{
    char words[100];
    memset(words, 'x', sizeof words);
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
