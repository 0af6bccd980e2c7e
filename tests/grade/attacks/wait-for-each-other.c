// wait-for-each-other: two placeholders that call each other, so that whichever is lent makes the
// other right.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

static int depth;

vec3 upper_left(Camera c)
{
    depth++;
    vec3 v = depth < 3 ? upper_right(c) - c.width * c.right : c.up;
    depth--;
    return v;
}

vec3 upper_right(Camera c)
{
    depth++;
    vec3 v = depth < 3 ? upper_left(c) + c.width * c.right : c.forward;
    depth--;
    return v;
}

vec3 across_30_up_10(Camera c)
{
    return upper_left(c) + 0.3 * c.width * c.right - 0.9 * c.height * c.up;
}
