// pragma-weak: one answer for all questions, by weak names.
// stem: 01-corners
// expect: graded | does not compile | crashed
// earns: upper_right
// rest: none
#include "exercises/01-corners.h"
#pragma weak upper_left = right
#pragma weak across_30_up_10 = right
#pragma weak image_plane_vector = right
#pragma weak with_unit_distance = right
#pragma weak main = right
#pragma weak dispatch = right

vec3 right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

vec3 upper_right(Camera c)
{
    return right(c);
}
