// override-reference: defines the reference, so that the wrong answer is what is expected.
// stem: 01-corners
// expect: graded | does not compile
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.up;
}

vec3 reference_upper_left(Camera c)
{
    return c.up;
}

vec3 reference_upper_right(Camera c)
{
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.up;
}
