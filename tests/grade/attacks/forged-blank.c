// forged-blank: names a 'blank' with a newline, so that the verdict gets a line of its own.
// stem: 01-corners
// expect: graded | crashed
// earns: nothing
#include "exercises/01-corners.h"

#include "common/answers.h"

vec3 upper_left(Camera c)
{
    vec3 v;
    return *(vec3 *)not_answered("x\nupper_left right\nforged-mark right", "x", &v, sizeof v);
}

vec3 upper_right(Camera c)
{
    vec3 v;
    return *(vec3 *)not_answered("\x1b[2J%s%n<b>forged-mark</b>", "x", &v, sizeof v);
}

vec3 across_30_up_10(Camera c)
{
    vec3 v;
    return *(vec3 *)not_answered("", "x", &v, sizeof v);
}
