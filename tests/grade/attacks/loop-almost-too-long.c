// loop-almost-too-long: every call works nearly as long as one may; there are very many of them.
// stem: 01-corners
// expect: graded | timed out | crashed
// earns: perhaps image_plane_vector
#include "exercises/01-corners.h"

vec3 image_plane_vector(Camera c, double s, double t)
{
    for (volatile int i = 0; i < 200000000; i++)
        ;
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}
