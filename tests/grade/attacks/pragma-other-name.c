// pragma-other-name: the answer goes by the reference's name, and another by the answer's.
// stem: 01-corners
// expect: does not compile | graded
// earns: nothing
#pragma redefine_extname upper_left reference_upper_left
#pragma redefine_extname upper_right upper_left
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.up;
}
