// laws-vectors.c - laws of the directions of light: how long, and where to.
#include "tests/07-shading/laws.h"

#include "tests/judge/reference/distinct_digits.h"

// Ten times what the contract allows.
static const double enough = 1e-8;

static bool not_finite(vec3 v)
{
    if (vec3_is_finite(v))
        return false;
    law_broken("a part of it is not a finite number");
    return true;
}

static double largest(vec3 v)
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

// In degrees: between two vectors, neither of them 0.
static double degrees_between(vec3 v, vec3 w)
{
    return atan2(vec3_length(vec3_cross(v, w)), vec3_dot(v, w)) * 180 / PI;
}

void law_surface_normal(vec3 yours, Sphere sphere, vec3 point)
{
    vec3 radius = point - sphere.center;
    double rounding = enough * (1 + largest(sphere.center) / sphere.radius);
    if (not_finite(yours))
        return;
    double length = vec3_length(yours);
    if (length > 0 && vec3_dot(yours, radius) < 0) {
        law_broken("your normal points into the sphere: %s degrees from the direction outward, "
                   "from the centre to the point",
                   number_text_to(degrees_between(yours, radius), 4).s);
    } else if (length > 0 && !(degrees_between(yours, radius) <= 60 * rounding)) {
        law_broken(
            "your normal is %s degrees off the direction outward, from the centre to the point",
            number_text_to(degrees_between(yours, radius), 4).s);
    } else if (!(fabs(length - 1) <= rounding)) {
        Apart a = apart(length, 1);
        law_broken("your normal has length %s, and must have %s", a.yours.s, a.right.s);
    }
}

void law_ray_to_light(Ray yours, vec3 from, Light light)
{
    double size = enough * (1 + largest(from) + largest(light.position));
    vec3 end = yours.origin + yours.direction;
    if (not_finite(yours.origin) || not_finite(yours.direction))
        return;
    if (!(largest(yours.origin - from) <= size)) {
        Apart a = apart_vec3(yours.origin, from);
        law_broken("your ray starts at %s; it must start at the given point, %s", a.yours.s,
                   a.right.s);
    } else if (light.kind == LIGHT_POINT && !(largest(end - light.position) <= size)) {
        Apart a = apart_vec3(end, light.position);
        law_broken("at t = 1 your ray is at %s; the point light is at %s", a.yours.s, a.right.s);
    } else if (light.kind == LIGHT_DISTANT &&
               !(largest(yours.direction - light.position) <= size)) {
        Apart a = apart_vec3(yours.direction, light.position);
        law_broken("your direction is %s; the distant light's, from everywhere, is %s", a.yours.s,
                   a.right.s);
    }
}

void law_mirror_direction(vec3 yours, vec3 direction, vec3 normal)
{
    double size = enough * (1 + vec3_length(direction));
    if (not_finite(yours))
        return;
    double in = without_noise(vec3_dot(direction, normal), size / 1e4);
    double out = without_noise(vec3_dot(yours, normal), size / 1e4);
    vec3 along_in = direction - in * normal, along_out = yours - out * normal;
    if (!(fabs(vec3_length(yours) - vec3_length(direction)) <= size)) {
        Apart a = apart(vec3_length(yours), vec3_length(direction));
        law_broken("your mirrored direction has length %s, and the incoming one %s: a mirror does "
                   "not change the length",
                   a.yours.s, a.right.s);
    } else if (!(fabs(out + in) <= size)) {
        Apart a = apart(out, -in);
        law_broken("along the normal your mirrored direction goes %s; the incoming one goes %s, so "
                   "it must be %s",
                   a.yours.s, number_text(in).s, a.right.s);
    } else if (!(largest(along_out - along_in) <= size)) {
        Apart a = apart_vec3(along_out, along_in);
        law_broken("without its part along the normal your mirrored direction is %s; that part of "
                   "the incoming one is %s, and must stay",
                   a.yours.s, a.right.s);
    }
}
