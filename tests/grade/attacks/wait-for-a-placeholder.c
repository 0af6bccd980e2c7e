// wait-for-a-placeholder: the first answer is any vector, and the others are made of it.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.up;
}

vec3 upper_right(Camera c)
{
    c.right = -c.right;
    return upper_left(c);
}

vec3 across_30_up_10(Camera c)
{
    return 0.7 * upper_left(c) + 0.3 * upper_right(c) - 0.9 * c.height * c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return (1 - s) * upper_left(c) + s * upper_right(c) - (1 - t) * c.height * c.up;
}
