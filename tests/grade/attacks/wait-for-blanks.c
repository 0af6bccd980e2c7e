// wait-for-blanks: every answer is made of one that is blank.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return image_plane_vector(c, 0, 1);
}

vec3 upper_right(Camera c)
{
    return image_plane_vector(c, 1, 1);
}

vec3 across_30_up_10(Camera c)
{
    return image_plane_vector(c, 0.3, 0.1);
}
