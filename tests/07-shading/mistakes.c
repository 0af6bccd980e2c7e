// mistakes.c - wrong answers to exercise 07, one file for each kind.
//
// In formulas n is the normal, l the direction to the light, e the direction to the eye, v a
// direction; c and r are the sphere's centre and radius.
#include "tests/07-shading/mistakes.h"

#include "tests/07-shading/mistakes-scene.h"

static const Mistake *const mistakes[] = {
    normal_mistakes,
    light_mistakes,
    mirror_mistakes,
    ambient_mistakes,
    diffuse_mistakes,
    phong_mistakes,
    halfway_mistakes,
    clamp_mistakes,
    gamma_mistakes,
    offset_mistakes,
    fixed_offset_mistakes,
    shadow_mistakes,
    shadow_sphere_mistakes,
    shade_mistakes,
    shade_light_mistakes,
    hidden_light_mistakes,
    mirrored_mistakes,
    seen_mistakes,
    mirror_depth_mistakes,
    term_limit_mistakes,
    shading_axis_mistakes,
    shadow_limit_mistakes,
    shade_limit_mistakes,
    mirror_limit_mistakes,
    NULL,
};
OF_STEM(mistakes)
