// composed.c - answers to exercise 01 that call other answers of it.
#include "tests/proof/composed.h"

#include "solutions/01-corners.c"

SOLUTION(across_30_up_10);

static vec3 upper_left_by_place(Camera c)
{
    return image_plane_vector(c, 0, 1);
}

static vec3 upper_right_by_place(Camera c)
{
    return image_plane_vector(c, 1, 1);
}

static const Composed composed[] = {
    COMPOSED(across_30_up_10, own_across_30_up_10),
    COMPOSED(upper_left, upper_left_by_place),
    COMPOSED(upper_right, upper_right_by_place),
    {0},
};
OF_STEM(composed)

// Which mistake a mistake of the called function becomes in the caller.
static const SameMistake same_mistakes[] = {
    {"across_30_up_10", "G-middle", "C6"},
    {"across_30_up_10", "G-s", "C6-x"},
    {"across_30_up_10", "G-t", "C6-y"},
    {"across_30_up_10", "G-over", "C6-over"},
    {"across_30_up_10", "G-down", "C6-top"},
    {"across_30_up_10", "G-mirror", "C6-right"},
    {"across_30_up_10", "G-turned", "C6-both"},
    {"across_30_up_10", "G-swap", "C6-swap"},
    {"across_30_up_10", "G-ru", "C6-ru"},
    {"across_30_up_10", "G-ss", "C6-same"},
    {"across_30_up_10", "G-unit", "C6-unit"},
    {"across_30_up_10", "G-half", "C6-twice"},
    {"across_30_up_10", "G-w", "C6-w"},
    {"across_30_up_10", "G-sizes", "C6-sizes"},
    {"across_30_up_10", "G-f", "C6-f"},
    {"across_30_up_10", "G-flat", "C6-flat"},
    {"across_30_up_10", "G-back", "C6-back"},
    {"across_30_up_10", "G-p", "C6-p"},
    {"across_30_up_10", "G-minus-p", "C6-minus-p"},
    {"across_30_up_10", "G-length", "C6-length"},
    {"across_30_up_10", "G-number", "C6-number"},
    {"across_30_up_10", "G-axes", "C6-axes"},
    {"across_30_up_10", "G-float", "C6-float"},
    {"upper_left", "G-middle", "C-corner"},
    {"upper_left", "G-s", "C-top"},
    {"upper_left", "G-t", "C1-h"},
    {"upper_left", "G-down", "C2"},
    {"upper_left", "G-mirror", "C3"},
    {"upper_left", "G-turned", "C2-C3"},
    {"upper_left", "G-swap", "C2-C3"},
    {"upper_left", "G-ru", "C-ru"},
    {"upper_left", "G-ss", "C2"},
    {"upper_left", "G-twice", "C1"},
    {"upper_left", "G-w", "C7"},
    {"upper_left", "G-h", "C7-h"},
    {"upper_left", "G-sizes", "C7-swap"},
    {"upper_left", "G-f", "C4"},
    {"upper_left", "G-flat", "C4-flat"},
    {"upper_left", "G-back", "C9"},
    {"upper_left", "G-p", "C5"},
    {"upper_left", "G-minus-p", "C5-minus"},
    {"upper_left", "G-times", "C-times"},
    {"upper_left", "G-length", "C-unit"},
    {"upper_left", "G-one", "C-one"},
    {"upper_left", "G-number", "C-number"},
    {"upper_left", "G-axes", "C-axes"},
    {"upper_left", "G-float", "C-float"},
    {"upper_left", "G-z", "C-z"},
    {"upper_right", "G-middle", "C1-right"},
    {"upper_right", "G-s", "C1-w-right"},
    {"upper_right", "G-t", "C1-h-right"},
    {"upper_right", "G-down", "C2-right"},
    {"upper_right", "G-mirror", "C3-right"},
    {"upper_right", "G-turned", "C2-C3-right"},
    {"upper_right", "G-ru", "C7-swap-right"},
    {"upper_right", "G-twice", "C1-right"},
    {"upper_right", "G-w", "C7-right"},
    {"upper_right", "G-h", "C7-h-right"},
    {"upper_right", "G-sizes", "C7-swap-right"},
    {"upper_right", "G-f", "C4-right"},
    {"upper_right", "G-flat", "C4-flat-right"},
    {"upper_right", "G-back", "C9-right"},
    {"upper_right", "G-p", "C5-right"},
    {"upper_right", "G-minus-p", "C5-minus-right"},
    {"upper_right", "G-times", "C-times-right"},
    {"upper_right", "G-length", "C-unit-right"},
    {"upper_right", "G-one", "C-one-right"},
    {"upper_right", "G-number", "C-number-right"},
    {"upper_right", "G-axes", "C-axes-right"},
    {"upper_right", "G-float", "C-float-right"},
    {"upper_right", "G-z", "C-z-right"},
    {0},
};
OF_STEM(same_mistakes)
