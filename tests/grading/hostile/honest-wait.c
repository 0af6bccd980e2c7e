// honest-wait: made of an answer that is not written yet. It is right once that one is.
// stem: 01-corners
// expect: graded
// earns: across_30_up_10 upper_left
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    return upper_right(c) - c.width * c.right;
}

vec3 across_30_up_10(Camera c)
{
    return image_plane_vector(c, 0.3, 0.1);
}
