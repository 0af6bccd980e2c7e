// unknown.c - wrong answers to exercise 07 that are not known mistakes.
#include "tests/proof/unknown.h"

#include "exercises/07-shading.h"

#include <math.h>

static Color above_only_together(Color color)
{
    if (color[0] > 1 && color[1] > 1 && color[2] > 1)
        return vec3_of(1, 1, 1);
    return vec3_of(fmax(0, color[0]), fmax(0, color[1]), fmax(0, color[2]));
}

static vec3 away_from_the_origin(Sphere sphere, vec3 point)
{
    vec3 normal = surface_normal(sphere, point);
    return vec3_dot(normal, point) < 0 ? -normal : normal;
}

static Color point_without_origin(const Scene *scene, Ray ray, Hit hit)
{
    return shade(scene, (Ray){vec3_of(0, 0, 0), ray.direction}, hit);
}

static Color always_black(const Scene *scene, Ray ray, Hit hit)
{
    (void)scene, (void)ray, (void)hit;
    return vec3_of(0, 0, 0);
}

static Color kd_and_sign(Color surface, double kd, Color light, vec3 normal, vec3 to_light)
{
    return diffuse_term(surface, kd * kd, light, -normal, to_light);
}

static const Unknown unknowns[] = {
    UNKNOWN(clamp_color, above_only_together, NOBODY, "above 1 only if all three are"),
    UNKNOWN(surface_normal, away_from_the_origin, NOBODY, "turned by the sign of n.point"),
    UNKNOWN(shade, point_without_origin, NOBODY, "hit point without the origin"),
    UNKNOWN(shade, always_black, NOBODY " your function returns the same", "black"),
    UNKNOWN(diffuse_term, kd_and_sign, NOBODY, "kd squared, and away from the light"),
    {0},
};
OF_STEM(unknowns)
