// memory-return-address: returns to somewhere else: past the check that it expects there.
// stem: 01-corners
// expect: crashed | timed out | graded
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    char **frame = __builtin_frame_address(0);
    frame[1] += 64;
    return c.up;
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    void **frame = __builtin_frame_address(0);
    frame[1] = *((void ***)frame)[0];
    return c.up;
}
