// override-read: its own read, which hands the answering program the deck's camera every time.
// stem: 01-corners
// expect: timed out | crashed | does not compile | graded
// earns: nothing
#include "exercises/01-corners.h"
#include <string.h>
#include <unistd.h>

ssize_t read(int file, void *bytes, size_t size)
{
    memset(bytes, 0, size);
    return (ssize_t)size;
}

vec3 upper_left(Camera c)
{
    return vec3_of(-1, 1, 4);
}
