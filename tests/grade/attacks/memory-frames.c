// memory-frames: walks its callers' frames without assembler, for the value that is expected.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

vec3 upper_left(Camera c)
{
    const double *at = __builtin_frame_address(0);
    for (int i = 0; i < 1000; i++) {
        vec3 v = vec3_of(at[i], at[i + 1], at[i + 2]);
        // Three numbers in a row that end on the plane, and are none that came in.
        if (fabs(vec3_dot(v, c.forward) - c.distance) < 1e-12 && vec3_dot(v, c.up) > 0)
            return v;
    }
    return c.up;
}
