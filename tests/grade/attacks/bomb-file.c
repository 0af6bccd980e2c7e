// bomb-file: two gigabytes that have to be written out.
// stem: 01-corners
// expect: does not compile | timed out
// earns: nothing
#include "exercises/01-corners.h"

char big[2147483647] = {1};

vec3 upper_left(Camera c)
{
    return vec3_of(big[1], 0, 0);
}
