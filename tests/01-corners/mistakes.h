// mistakes.h - one slip, two corners: the same wrong step on the left and on the right.
#ifndef TESTS_01_CORNERS_MISTAKES_H
#define TESTS_01_CORNERS_MISTAKES_H

#include "exercises/01-corners.h"
#include "tests/judge/mistake.h"

// From slip(camera, side), where side is -1 for the left corner and 1 for the right one.
#define ON_BOTH_SIDES(slip)                                                                        \
    static vec3 slip##_left(Camera c)                                                              \
    {                                                                                              \
        return slip(c, -1);                                                                        \
    }                                                                                              \
    static vec3 slip##_right(Camera c)                                                             \
    {                                                                                              \
        return slip(c, 1);                                                                         \
    }

// The two rows of a table for such a slip.
#define SIDES(id, slip, left, right, why, picture)                                                 \
    MISTAKE(id, upper_left, slip##_left, left, why, picture),                                      \
        MISTAKE(id "-right", upper_right, slip##_right, right, why, picture)

#endif
