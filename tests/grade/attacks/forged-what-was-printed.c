// forged-what-was-printed: rewinds, empties and stretches the file that catches what is printed.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <unistd.h>

vec3 upper_left(Camera c)
{
    fcntl(1, F_SETFL, O_NONBLOCK);
    if (ftruncate(1, 0) != 0 || ftruncate(1, 1 << 19) != 0 || lseek(1, 1 << 18, SEEK_SET) < 0 ||
        write(1, "forged-mark\x1b[2J\n", 16) < 0 || ftruncate(1, 1L << 40) != 0)
        return c.right;
    return c.up;
}
