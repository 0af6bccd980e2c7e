// read-the-keyboard: waits for the instructor to type something.
// stem: 01-corners
// expect: graded | timed out | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <stdio.h>

vec3 upper_left(Camera c)
{
    return vec3_of(getchar(), getchar(), getchar());
}
