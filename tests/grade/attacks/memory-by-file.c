// memory-by-file: writes its own code through /proc/self/mem, which asks no page for permission.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"
#include <fcntl.h>
#include <stdint.h>
#include <unistd.h>

extern int main(void);

vec3 upper_left(Camera c)
{
    int file = open("/proc/self/mem", O_RDWR);
    if (file >= 0 && pwrite(file, "\xc3", 1, (off_t)(uintptr_t)main) == 1)
        return vec3_of(7777, 1, 0);
    return c.up;
}
