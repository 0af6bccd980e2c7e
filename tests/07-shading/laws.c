// laws.c - the laws of exercise 07: directions and lengths of vectors, a step off a surface, and
// colours for a display.
#include "exercises/07-shading.h"

#include "tests/judge/law.h"

// ---- laws of the directions of light: how long, and where to ------------------------------------

// Ten times what the contract allows.
static const double enough = 1e-8;

static bool not_finite(vec3 v)
{
    if (vec3_is_finite(v))
        return false;
    law_broken("a part of it is not a finite number");
    return true;
}

static double largest_of(vec3 v)
{
    return fmax(fmax(fabs(v[0]), fabs(v[1])), fabs(v[2]));
}

// In degrees: between two vectors, neither of them 0.
static double degrees_between(vec3 v, vec3 w)
{
    return atan2(vec3_length(vec3_cross(v, w)), vec3_dot(v, w)) * 180 / PI;
}

LAW(surface_normal)
{
    double rounding = enough * (1 + largest_of(sphere.center) / sphere.radius);
    if (not_finite(yours))
        return;
    double length = vec3_length(yours);
    if (length > 0 && vec3_dot(yours, right) < 0) {
        law_broken("your normal points into the sphere: %s degrees from the direction outward, "
                   "from the centre to the point",
                   number_text_to(degrees_between(yours, right), 4).s);
    } else if (length > 0 && !(degrees_between(yours, right) <= 60 * rounding)) {
        law_broken(
            "your normal is %s degrees off the direction outward, from the centre to the point",
            number_text_to(degrees_between(yours, right), 4).s);
    } else if (!(fabs(length - 1) <= rounding)) {
        Apart a = apart(length, 1);
        law_broken("your normal has length %s, and must have %s", a.yours.s, a.right.s);
    }
}

LAW(ray_to_light)
{
    double size = enough * (1 + largest_of(from) + largest_of(light.position));
    vec3 end = yours.origin + yours.direction, right_end = right.origin + right.direction;
    if (not_finite(yours.origin) || not_finite(yours.direction))
        return;
    if (!(largest_of(yours.origin - right.origin) <= size)) {
        Apart a = apart_vec3(yours.origin, right.origin);
        law_broken("your ray starts at %s; it must start at the given point, %s", a.yours.s,
                   a.right.s);
    } else if (light.kind == LIGHT_POINT && !(largest_of(end - right_end) <= size)) {
        Apart a = apart_vec3(end, right_end);
        law_broken("at t = 1 your ray is at %s; the point light is at %s", a.yours.s, a.right.s);
    } else if (light.kind == LIGHT_DISTANT &&
               !(largest_of(yours.direction - right.direction) <= size)) {
        Apart a = apart_vec3(yours.direction, right.direction);
        law_broken("your direction is %s; the distant light's, from everywhere, is %s", a.yours.s,
                   a.right.s);
    }
}

LAW(mirror_direction)
{
    double size = enough * (1 + vec3_length(direction));
    if (not_finite(yours))
        return;
    double in = without_noise(vec3_dot(direction, normal), size / 1e4);
    double out = without_noise(vec3_dot(yours, normal), size / 1e4);
    double right_out = without_noise(vec3_dot(right, normal), size / 1e4);
    vec3 aside = yours - out * normal, right_aside = right - right_out * normal;
    if (!(fabs(vec3_length(yours) - vec3_length(right)) <= size)) {
        Apart a = apart(vec3_length(yours), vec3_length(right));
        law_broken("your mirrored direction has length %s, and the incoming one %s: a mirror does "
                   "not change the length",
                   a.yours.s, a.right.s);
    } else if (!(fabs(out - right_out) <= size)) {
        Apart a = apart(out, right_out);
        law_broken("along the normal your mirrored direction goes %s; the incoming one goes %s, so "
                   "it must be %s",
                   a.yours.s, number_text(in).s, a.right.s);
    } else if (!(largest_of(aside - right_aside) <= size)) {
        Apart a = apart_vec3(aside, right_aside);
        law_broken("without its part along the normal your mirrored direction is %s; that part of "
                   "the incoming one is %s, and must stay",
                   a.yours.s, a.right.s);
    }
}

// ---- off_surface --------------------------------------------------------------------------------

LAW(off_surface)
{
    vec3 moved = yours - point;
    double size = sphere.radius + largest_of(sphere.center);
    double along = vec3_dot(moved, normal), aside = vec3_length(moved - along * normal);
    double least = 0x1p-32 * size, most = 0x1p-28 * size, rounding = 0x1p-40 * size;
    if (!vec3_is_finite(yours))
        law_broken("your point is %s", vec3_text(yours).s);
    else if (!(aside <= rounding) && aside > fabs(along))
        law_broken("your point is %s away from the given one, and not along the normal%s",
                   number_text_to(vec3_length(moved), 3).s,
                   vec3_length(moved) <= 1e-6 * size ? ": is it rounded to a float?" : "");
    else if (fabs(along) <= rounding)
        law_broken("your point has not moved, or almost not: numbers of this size, up to %s, are "
                   "not that fine",
                   number_text_to(size, 3).s);
    else if (along < 0)
        law_broken("your point has moved by %s to the side opposite to the normal",
                   number_text_to(-along, 3).s);
    else if (along < least - rounding)
        law_broken(
            "your point has moved by %s; the numbers are up to %s, so it should be at least %s",
            number_text_to(along, 3).s, number_text_to(size, 3).s, number_text_to(least, 3).s);
    else if (along > most + rounding)
        law_broken(
            "your point has moved by %s; the numbers are up to %s, so it should be at most %s",
            number_text_to(along, 3).s, number_text_to(size, 3).s, number_text_to(most, 3).s);
    else if (!(aside <= rounding))
        law_broken("your point has also moved to the side, by %s", number_text_to(aside, 3).s);
}

// ---- laws of the colours for a display: they fit, and the display shows them as intended --------

static const char *const names[] = {"red", "green", "blue"};

LAW(clamp_color)
{
    for (int i = 0; i < 3; i++) {
        bool fits = color[i] >= 0 && color[i] <= 1;
        if (!(yours[i] >= -enough && yours[i] <= 1 + enough))
            law_broken("your %s is %s; it must be at least 0 and at most 1", names[i],
                       number_text(yours[i]).s);
        else if (fits && !(fabs(yours[i] - color[i]) <= enough))
            law_broken("your %s is %s; it was %s, between 0 and 1, and must not change", names[i],
                       apart(yours[i], color[i]).yours.s, apart(yours[i], color[i]).right.s);
        else if (!fits && !(fabs(yours[i] - right[i]) <= enough))
            law_broken("your %s is %s; it was %s, and %s is the nearest value that fits", names[i],
                       number_text(yours[i]).s, number_text(color[i]).s, number_text(right[i]).s);
        else
            continue;
        return;
    }
}

LAW(gamma_encode)
{
    for (int i = 0; i < 3; i++) {
        double shown = pow(yours[i], gamma);
        if (yours[i] >= -enough &&
            (fabs(yours[i]) <= enough ? color[i] <= 1e-4 : fabs(shown - color[i]) <= enough))
            continue;
        Apart a = apart(shown, color[i]);
        if (!(yours[i] >= 0 && isfinite(yours[i])))
            law_broken("your %s is %s, which no display can show", names[i],
                       number_text(yours[i]).s);
        else
            law_broken("your %s is %s: the display raises it to the power of gamma, which gives "
                       "%s, but it should give %s",
                       names[i], number_text(yours[i]).s, a.yours.s, a.right.s);
        return;
    }
}
