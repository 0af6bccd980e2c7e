// override-check: Check's functions that count what failed.
// stem: 01-corners
// expect: graded
// earns: upper_right
#include "exercises/01-corners.h"

void ck_assert_failed(const char *file, int line, const char *words, ...)
{
}

void _ck_assert_failed(const char *file, int line, const char *words, ...)
{
}

int srunner_ntests_failed(void *runner)
{
    return 0;
}

void mark_point(void)
{
}

vec3 upper_left(Camera c)
{
    ck_assert_failed("", 0, "");
    return c.up;
}

vec3 upper_right(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}
