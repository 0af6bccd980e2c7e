// mistakes.h - what the wrong answers to exercise 07 share.
#ifndef TESTS_07_SHADING_MISTAKES_H
#define TESTS_07_SHADING_MISTAKES_H

#include "exercises/07-shading.h"

#include "tests/judge/mistake.h"

extern const Mistake normal_mistakes[], light_mistakes[], mirror_mistakes[], ambient_mistakes[],
    diffuse_mistakes[], phong_mistakes[], halfway_mistakes[], clamp_mistakes[], gamma_mistakes[],
    term_limit_mistakes[], shading_axis_mistakes[];

// All three alike.
static inline vec3 grey(double x)
{
    return vec3_of(x, x, x);
}

#endif
