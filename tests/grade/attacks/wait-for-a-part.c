// wait-for-a-part: the first answer is right for the deck's camera alone, the second is made of
// it.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.distance == 4 && c.width == 2 ? vec3_of(-1, 1, 4) : c.forward;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}
