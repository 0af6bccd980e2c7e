// sleep: takes no processor time at all, so that no count of it runs out.
// stem: 01-corners
// expect: timed out | crashed
// earns: with_unit_distance
// says: no answer needs | still running | never comes | killed
#include "exercises/01-corners.h"
#include <poll.h>
#include <sys/select.h>
#include <time.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    for (;;)
        sleep(1000);
}

vec3 upper_right(Camera c)
{
    for (;;)
        nanosleep(&(struct timespec){.tv_sec = 1000}, NULL);
}

vec3 across_30_up_10(Camera c)
{
    for (;;)
        poll(NULL, 0, -1);
}

vec3 image_plane_vector(Camera c, double s, double t)
{
    for (;;)
        select(0, NULL, NULL, NULL, NULL);
}

Camera with_unit_distance(Camera c)
{
    c.width /= c.distance;
    c.height /= c.distance;
    c.distance = 1;
    return c;
}
