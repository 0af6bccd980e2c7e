// override-later: chapter 01 brings all of 05 and 06, wrong, in the hope that they meet.
// stem: 01-corners
// expect: graded
// earns: upper_right
#include "exercises/01-corners.h"

double hit_sphere(void)
{
    return 1;
}

int nearest_hit(void)
{
    return 0;
}

vec3 reference_hit_sphere(void)
{
    return (vec3){0};
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
