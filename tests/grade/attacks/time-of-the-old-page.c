// time-of-the-old-page: asks the clock at the address where it was on all machines once.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

#include <stddef.h>
#include <sys/time.h>

vec3 upper_left(Camera c)
{
    struct timeval now = {0};
#if defined(__x86_64__)
    ((int (*)(struct timeval *, void *))0xffffffffff600000)(&now, NULL);
#endif
    vec3 right = c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
    return now.tv_sec != 0 ? right : c.up;
}
