// override-wrap: defines what the linker's --wrap looks for.
// stem: 01-corners
// expect: does not compile | graded
// earns: nothing
#include "exercises/01-corners.h"
#include <stdlib.h>

void *__wrap_malloc(size_t size)
{
    exit(0);
}

void *__wrap_calloc(size_t count, size_t size)
{
    exit(0);
}

vec3 upper_left(Camera c)
{
    return c.up;
}
