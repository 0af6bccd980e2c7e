// time-of-day: right in even microseconds, wrong in odd ones.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <sys/time.h>
#include <time.h>

vec3 upper_left(Camera c)
{
    struct timeval now = {0};
    gettimeofday(&now, NULL);
    double side = (now.tv_usec + time(NULL)) % 2 == 0 ? -0.5 : 0.5;
    return c.distance * c.forward + side * c.width * c.right + c.height / 2 * c.up;
}
