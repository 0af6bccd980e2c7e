#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return c.distance * c.forward - c.width * c.right + c.height * c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width * c.right + c.height * c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    vec3 x = (2 * s - 1) * c.width * c.right;
    vec3 y = (2 * t - 1) * c.height * c.up;
    return c.distance * c.forward + x + y;
}

vec3 across_30_up_10(Camera c)
{
    return image_plane_vector(c, 0.3, 0.1);
}

Camera with_unit_distance(Camera c)
{
    c.width /= c.distance;
    c.height /= c.distance;
    c.distance /= c.distance;
    return c;
}
