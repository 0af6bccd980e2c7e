// 07-shading.c - wrong answers to exercise 07: their tables.
#include "tests/mistakes/07-shading-scene.h"

const Mistake *const mistakes[] = {
    offset_mistakes,
    fixed_offset_mistakes,
    shadow_mistakes,
    shadow_sphere_mistakes,
    shade_mistakes,
    shade_light_mistakes,
    hidden_light_mistakes,
    mirror_mistakes,
    seen_mistakes,
    mirror_depth_mistakes,
    NULL,
};
