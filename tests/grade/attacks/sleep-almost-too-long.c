// sleep-almost-too-long: every call takes nearly as long as one may; there are very many of them.
// stem: 01-corners
// expect: timed out | crashed | graded
// earns: perhaps image_plane_vector
#include "exercises/01-corners.h"
#include <unistd.h>

vec3 image_plane_vector(Camera c, double s, double t)
{
    usleep(900000);
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}
