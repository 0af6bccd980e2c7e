// reference-left-on-the-stack: calls an answer of the chapter, then digs in the stack it has used.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

static vec3 dig(int depth)
{
    volatile double below[512];
    return vec3_of(below[depth], below[depth + 1], below[depth + 2]);
}

vec3 upper_left(Camera c)
{
    upper_right(c);
    double d = c.distance;
    for (int i = 0; i < 500; i++) {
        vec3 v = dig(i);
        if (vec3_dot(v, c.forward) == d)
            return v;
    }
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.right;
}
