// table: no formula, only the answers to the cameras that the public tests ask about.
// stem: 01-corners
// expect: graded
// earns: nothing
#include "exercises/01-corners.h"

static const struct {
    double distance;
    vec3 left, right;
} table[] = {{4, {-1, 1, 4}, {1, 1, 4}}, {6, {0, 7.5, 1.5}, {6, 1.5, 4.5}}};

vec3 upper_left(Camera c)
{
    return table[c.distance != 4].left;
}

vec3 upper_right(Camera c)
{
    return table[c.distance != 4].right;
}

vec3 across_30_up_10(Camera c)
{
    return c.distance == 4 ? vec3_of(-0.4, -0.8, 4) : vec3_of(0, 4.8, 4.2);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return s == 0.5    ? vec3_of(2, 4, 4)
           : s == 0    ? vec3_of(-2, 6.5, 3.5)
           : s == 0.25 ? vec3_of(1, 5.75, 2.75)
                       : c.forward;
}
