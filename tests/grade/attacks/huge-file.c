// huge-file: a terabyte with nothing in it, wherever a file can be made.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    const char *places[] = {"hostile-was-here", "/tmp/hostile-was-here",
                            "/dev/shm/hostile-was-here", "/var/tmp/hostile-was-here",
                            "@OUT@/hostile-was-here"};
    for (int i = 0; i < 5; i++) {
        int file = open(places[i], O_RDWR | O_CREAT, 0600);
        if (file >= 0)
            return vec3_of(7777, i, ftruncate(file, 1L << 40));
    }
    return c.up;
}
