// forged-wait: calls a blank and throws away what comes, to pass as 'waiting' with full marks.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

#include "common/answers.h"

vec3 upper_left(Camera c)
{
    vec3 thrown_away = upper_right(c);
    return c.up + 0 * thrown_away;
}

vec3 upper_right(Camera c)
{
    return NOT_ANSWERED(vec3);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    with_unit_distance(c);
    return c.up;
}
