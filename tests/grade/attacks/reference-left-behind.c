// reference-left-behind: returns what is not set, hoping that the right answer still lies there.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    vec3 v;
    upper_right(c);
    return v;
}

vec3 upper_right(Camera c)
{
    vec3 v;
    return v;
}

Camera with_unit_distance(Camera c)
{
    Camera left;
    return left;
}
