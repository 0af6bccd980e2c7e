#include "exercises/01-corners.h"

// center = d f, then half of w and h to each side
vec3 upper_left(Camera c)
{
    vec3 center = c.distance * c.forward;
    return center + c.height * c.up / 2 - c.width * c.right / 2;
}

vec3 upper_right(Camera c)
{
    vec3 center = c.distance * c.forward;
    return center + c.height * c.up / 2 + c.width * c.right / 2;
}

vec3 across_30_up_10(Camera c)
{
    // 50% - 30% = 20% left of the center, 50% - 10% = 40% below
    return c.distance * c.forward - c.width * c.right / 5 - c.height * c.up * 2 / 5;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    vec3 w = c.width * c.right, h = c.height * c.up;
    return c.distance * c.forward + s * w + t * h - w / 2 - h / 2;
}

Camera with_unit_distance(Camera c)
{
    Camera n = c;
    n.height = c.height / c.distance;
    n.width = c.width / c.height * n.height;
    n.distance = 1;
    return n;
}
