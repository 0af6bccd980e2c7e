#include "exercises/01-corners.h"

#include "common/answers.h"

vec3 upper_left(Camera c)
{
    // BEGIN SOLUTION
    vec3 v = c.forward * c.distance;
    v -= c.right * c.width * 0.5;
    v += c.up * c.height * 0.5;
    return v;
    // END SOLUTION
}

vec3 upper_right(Camera c)
{
    // BEGIN SOLUTION
    vec3 v = c.forward * c.distance;
    v += c.right * c.width * 0.5;
    v += c.up * c.height * 0.5;
    return v;
    // END SOLUTION
}

vec3 across_30_up_10(Camera c)
{
    // BEGIN SOLUTION
    return upper_left(c) + 0.3 * c.width * c.right - 0.9 * c.height * c.up;
    // END SOLUTION
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    // BEGIN SOLUTION
    return upper_left(c) + s * c.width * c.right - (1 - t) * c.height * c.up;
    // END SOLUTION
}

Camera with_unit_distance(Camera c)
{
    // BEGIN SOLUTION
    double d = c.distance;
    c.distance = 1;
    c.width = c.width / d;
    c.height = c.height / d;
    return c;
    // END SOLUTION
}
