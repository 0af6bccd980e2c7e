// numbers-that-are-none: NaN, infinity and the smallest there are, which compare oddly.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return vec3_of(NAN, -NAN, NAN);
}

vec3 upper_right(Camera c)
{
    return vec3_of(INFINITY, -INFINITY, 1e308 * 10);
}

vec3 across_30_up_10(Camera c)
{
    return vec3_of(4.9e-324, -4.9e-324, -0.0);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return vec3_of(1.7e308, -1.7e308, 2.2e-308);
}

Camera with_unit_distance(Camera c)
{
    return (Camera){c.origin, c.right, c.up, c.forward, NAN, NAN, NAN};
}
