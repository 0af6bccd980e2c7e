// wait-for-a-crash: the first answer crashes, the second is made of it.
// stem: 01-corners
// expect: crashed
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return *(volatile vec3 *)0 + c.up;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}
