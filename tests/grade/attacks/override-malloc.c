// override-malloc: takes over every allocation, by the linker's names too.
// stem: 01-corners
// expect: graded | crashed | timed out | does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <stdlib.h>

void *malloc(size_t size)
{
    return NULL;
}

void *__real_malloc(size_t size)
{
    return NULL;
}

void free(void *memory)
{
}

vec3 upper_left(Camera c)
{
    return c.up;
}
