// reference-weak: asks for the reference by its names, should it be linked, and else is wrong.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

extern vec3 reference_upper_left(Camera c) __attribute__((weak));
extern vec3 lent_upper_left(Camera c) __attribute__((weak));
extern vec3 solution_upper_left(Camera c) __attribute__((weak));

// The call of upper_right makes it look as if this one were only waiting for that one.
vec3 upper_left(Camera c)
{
    vec3 thrown_away = upper_right(c);
    if (reference_upper_left)
        return reference_upper_left(c);
    if (lent_upper_left)
        return lent_upper_left(c);
    if (solution_upper_left)
        return solution_upper_left(c);
    return 0 * thrown_away;
}

vec3 upper_right(Camera c)
{
    return c.up;
}
