// override-write: its own write, which says that it wrote and keeps the answer to itself.
// stem: 01-corners
// expect: timed out | crashed | does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <unistd.h>

ssize_t write(int file, const void *bytes, size_t size)
{
    return (ssize_t)size;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
