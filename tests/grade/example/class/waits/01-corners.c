#include "exercises/01-corners.h"

#include "common/answers.h"

vec3 upper_left(Camera c)
{
    // BEGIN SOLUTION
    return c.distance * c.forward - c.width / 2 * c.right - c.height / 2 * c.up;
    // END SOLUTION
}

vec3 upper_right(Camera c)
{
    // BEGIN SOLUTION
    return upper_left(c) + c.width * c.right;
    // END SOLUTION
}

vec3 across_30_up_10(Camera c)
{
    // BEGIN SOLUTION
    return image_plane_vector(c, 0.3, 0.1);
    // END SOLUTION
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    // BEGIN SOLUTION
    return c.distance * c.forward + (0.5 - s) * c.width * c.right + (t - 0.5) * c.height * c.up;
    // END SOLUTION
}

Camera with_unit_distance(Camera c)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Camera);
    // END SOLUTION
}
