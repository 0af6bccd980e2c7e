#include "exercises/01-corners.h"

#include "common/answers.h"

// start at the lower left corner and count from there
static vec3 lower_left(Camera c)
{
    return c.distance * c.forward - (c.width * c.right + c.height * c.up) / 2;
}

vec3 upper_left(Camera c)
{
    return lower_left(c) + c.height * c.up;
}

vec3 upper_right(Camera c)
{
    return lower_left(c) + c.height * c.up + c.width * c.right;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    // between the bottom edge and the top edge
    vec3 bottom = lower_left(c) + s * c.width * c.right;
    vec3 top = upper_left(c) + s * c.width * c.right;
    return (1 - t) * bottom + t * top;
}

vec3 across_30_up_10(Camera c)
{
    return 0.7 * lower_left(c) + 0.3 * (lower_left(c) + c.width * c.right) + c.height / 10 * c.up;
}

Camera with_unit_distance(Camera c)
{
    double k = 1.0 / c.distance;
    return (Camera){c.origin, c.right, c.up, c.forward, 1.0, k * c.width, k * c.height};
}
