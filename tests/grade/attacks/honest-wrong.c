// honest-wrong: the whole width for the half of it; what is made of it waits; the rest is blank.
// stem: 01-corners
// expect: graded
// earns: across_30_up_10 upper_right
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.distance * c.forward - c.width * c.right + c.height * c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

vec3 across_30_up_10(Camera c)
{
    return image_plane_vector(c, 0.3, 0.1);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return c.distance * c.forward + s * c.width * c.right + t * c.height * c.up;
}
