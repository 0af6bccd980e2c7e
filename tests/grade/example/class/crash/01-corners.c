#include "exercises/01-corners.h"

// everything starts at the upper left corner
vec3 upper_left(Camera c)
{
    return image_plane_vector(c, 0, 1);
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

vec3 across_30_up_10(Camera c)
{
    return upper_right(c) - 0.7 * c.width * c.right - 0.9 * c.height * c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return upper_left(c) + s * c.width * c.right - (1 - t) * c.height * c.up;
}

Camera with_unit_distance(Camera c)
{
    Camera unit = c;
    unit.distance = 1;
    unit.width = c.width / c.distance;
    unit.height = c.height / c.distance;
    return unit;
}
