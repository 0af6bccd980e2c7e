// exit-by-signal: kills itself in a way that no handler sees, and stops itself in another.
// stem: 01-corners
// expect: crashed | timed out
// earns: across_30_up_10 image_plane_vector
// says: killed | still running | crashed | no answer
#include "exercises/01-corners.h"
#include <signal.h>

vec3 upper_left(Camera c)
{
    raise(SIGKILL);
    return c.up;
}

vec3 upper_right(Camera c)
{
    raise(SIGSTOP);
    return c.up;
}

vec3 across_30_up_10(Camera c)
{
    return image_plane_vector(c, 0.3, 0.1);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}
