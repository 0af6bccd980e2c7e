// numbers-as-they-came: gives back what it was given.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.forward;
}

vec3 upper_right(Camera c)
{
    return (vec3){0};
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return vec3_of(s, t, c.distance);
}

Camera with_unit_distance(Camera c)
{
    return c;
}
