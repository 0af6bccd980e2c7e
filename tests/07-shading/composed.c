// composed.c - answers to exercise 07 that call other answers of it.
#include "tests/proof/composed.h"

#include "exercises/07-shading.h"

// It calls itself: that is not a call of another answer.
Color own_trace_ray(const Scene *scene, Ray ray, int depth);
#define trace_ray own_trace_ray
#include "solutions/07-shading.c"
#undef trace_ray

SOLUTION(phong_term);
SOLUTION(visibility);
SOLUTION(shade);

static const Composed composed[] = {
    COMPOSED(phong_term, own_phong_term),
    COMPOSED(visibility, own_visibility),
    COMPOSED(shade, own_shade),
    COMPOSED(trace_ray, own_trace_ray),
    {0},
};
OF_STEM(composed)

// Which mistake a mistake of the called function becomes in the caller.
static const SameMistake same_mistakes[] = {
    {"phong_term", "MI-back", "PH-reversed"},
    {"phong_term", "MI-opposite", "PH-le"},
    {"phong_term", "MI-normal", "PH-ne"},
    {"phong_term", "MI-part", "PH-unit-late"},
    {"visibility", "S2-ray", "V-reversed"},
    {"visibility", "LI-distant", "V-minus"},
    {"visibility", "LI-point", "V-always-minus"},
    {"visibility", "LI-unit", "V-unit"},
    {"visibility", "LI-unit-point", "V-unit"},
    {"shade", "W3-length", "W-unit in part"},
    {"shade", "W-length", "W-unit in part"},
    {"shade", "MI-back", "S-eye"},
    {"shade", "AM-kd", "S-kd"},
    {"shade", "AM-alone", "S-raw"},
    {"shade", "AM-tenth", "S-nff"},
    {"shade", "S2", "L-diffuse"},
    {"shade", "DI-min", "L-diffuse"},
    {"shade", "DI-kd", "L-kd"},
    {"shade", "PH-ks", "L-ks"},
    {"shade", "PH-light", "L-white-s in part"},
    {"shade", "PH-power", "L-shine"},
    {"shade", "PH-reversed", "S-eye"},
    {"shade", "PH-light-reversed", "L-specular"},
    {"shade", "PH-halfway", "L-halfway"},
    {"shade", "O-none", "S-acne"},
    {"shade", "O-other", "S-only-ambient"},
    {"shade", "O-outward", "S-outside"},
    {"shade", "O-0.001", "S-1e-3"},
    {"shade", "O-1e-4", "S-1e-4"},
    {"shade", "O-1e-5", "S-1e-5"},
    {"shade", "O-1e-6", "S-1e-6"},
    {"shade", "V-reversed", "S-only-ambient"},
    {"shade", "V-through", "S-only-ambient"},
    {"shade", "V-behind", "S-only-ambient"},
    {"shade", "V-line", "S-only-ambient"},
    {"shade", "V-inverted", "L-inverted"},
    {"shade", "V-1", "L-shadow"},
    {"shade", "V-0", "S-only-ambient"},
    {"shade", "PH-ks-shine", "L-ks-and-shine"},
    {"trace_ray", "PH-light-reversed", "T-highlight"},
    {"trace_ray", "O-1e-6", "T-1e-6"},
    {"trace_ray", "V-reversed", "T-ambient"},
    {"trace_ray", "V-through", "T-ambient"},
    {"trace_ray", "V-behind", "T-ambient"},
    {"trace_ray", "V-line", "T-ambient"},
    {"trace_ray", "V-0", "T-ambient"},
    {"trace_ray", "S-only-ambient", "T-ambient"},
    {"trace_ray", "S-flat", "T-flat"},
    {"trace_ray", "W3-shade", "T-away"},
    {"trace_ray", "L-specular", "T-highlight"},
    {"shade", "O-1e-9", "S-1e-9"},
    {"trace_ray", "O-1e-9", "T-1e-9"},
    {0},
};
OF_STEM(same_mistakes)
