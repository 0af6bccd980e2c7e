// honest-wait: made of an answer that is wrong in a known way. It is right once that one is.
// stem: 01-corners
// expect: graded
// earns: upper_right across_30_up_10
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.distance * c.forward - c.width / 2 * c.right - c.height / 2 * c.up;
}

vec3 upper_right(Camera c)
{
    return upper_left(c) + c.width * c.right;
}

vec3 across_30_up_10(Camera c)
{
    return image_plane_vector(c, 0.3, 0.1);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return c.distance * c.forward + (0.5 - s) * c.width * c.right + (t - 0.5) * c.height * c.up;
}
