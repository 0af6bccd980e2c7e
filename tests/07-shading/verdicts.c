// verdicts.c - wrong answers to exercise 07 that are not known mistakes, and the verdict on each.
#include "exercises/07-shading.h"

#include "tests/judge/known.h"

#include <math.h>

UNNAMED(clamp_color, NOBODY, "above 1 only if all three are")
{
    if (color[0] > 1 && color[1] > 1 && color[2] > 1)
        return vec3_of(1, 1, 1);
    return vec3_of(fmax(0, color[0]), fmax(0, color[1]), fmax(0, color[2]));
}

UNNAMED(surface_normal, NOBODY, "turned by the sign of n.point")
{
    vec3 normal = surface_normal(sphere, point);
    return vec3_dot(normal, point) < 0 ? -normal : normal;
}

UNNAMED_LINE(shade, NOBODY, "hit point without the origin",
             return shade(scene, (Ray){vec3_of(0, 0, 0), ray.direction}, hit))
UNNAMED_LINE(shade, NOBODY " your function returns the same", "black", return vec3_of(0, 0, 0))

UNNAMED(diffuse_term, NOBODY, "kd squared, and away from the light")
{
    return diffuse_term(surface, kd * kd, light, -normal, to_light);
}
