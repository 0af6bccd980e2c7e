// override-memory: memcpy, memcmp and memchr that lie. Its own answers go through them.
// stem: 01-corners
// expect: graded | crashed | timed out | does not compile
// earns: nothing
#include "exercises/01-corners.h"
#include <string.h>

void *memcpy(void *restrict to, const void *restrict from, size_t size)
{
    for (size_t i = 0; i < size; i++)
        ((volatile char *)to)[i] = 0;
    return to;
}

int memcmp(const void *a, const void *b, size_t size)
{
    return 0;
}

void *memchr(const void *in, int what, size_t size)
{
    return NULL;
}

vec3 upper_left(Camera c)
{
    return c.up;
}
