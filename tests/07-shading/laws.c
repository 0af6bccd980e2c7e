// laws.c - the laws of exercise 07: directions and lengths of vectors, a step off a surface,
// colors for a display, shares of light, and what is lit.
#include "exercises/07-shading.h"

#include "tests/judge/known.h"

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
                   "from the center to the point",
                   number_text_to(degrees_between(yours, right), 4).s);
    } else if (length > 0 && !(degrees_between(yours, right) <= 60 * rounding)) {
        law_broken(
            "your normal is %s degrees off the direction outward, from the center to the point",
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

// ---- offset_from_surface
// --------------------------------------------------------------------------------

LAW(offset_from_surface)
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

// ---- laws of the colors for a display: they fit, and the display shows them as intended --------

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

// ---- laws of the terms: the share of each light that comes back, color by color ---------------

static bool color_not_finite(Color color)
{
    for (int i = 0; i < 3; i++)
        if (!isfinite(color[i])) {
            law_broken("your %s is not a finite number", names[i]);
            return true;
        }
    return false;
}

// The share, in each color; 'of' names the whole.
static void is_share(Color yours, double share, const char *why, Color of, const char *of_what)
{
    for (int i = 0; i < 3; i++) {
        if (fabs(yours[i] - share * of[i]) <= enough * (1 + fabs(share * of[i])))
            continue;
        Apart a = apart(yours[i] / of[i], share);
        if (of[i] == 0)
            law_broken("your %s is %s, but %s has no %s", names[i], number_text(yours[i]).s,
                       of_what, names[i]);
        else
            law_broken("your %s is %s times %s; %s is %s", names[i], a.yours.s, of_what, why,
                       a.right.s);
        return;
    }
}

static bool is_black(Color yours, const char *why)
{
    for (int i = 0; i < 3; i++)
        if (!(fabs(yours[i]) <= enough)) {
            law_broken("%s, so nothing comes back; your %s is %s", why, names[i],
                       number_text(yours[i]).s);
            return false;
        }
    return true;
}

LAW(ambient_term)
{
    if (!color_not_finite(yours))
        is_share(yours, kd, "kd", ambient * surface, "the surface's times the light's");
}

LAW(diffuse_term)
{
    double cosine = law_facts()[0];
    if (color_not_finite(yours))
        return;
    if (cosine < 0) {
        is_black(yours, "the light is behind the surface");
        return;
    }
    char what[240];
    snprintf(what, sizeof what, "kd times the cosine of %s degrees",
             number_text_to(acos(fmin(1, cosine)) * 180 / PI, 4).s);
    is_share(yours, kd * cosine, what, surface * light, "the surface's times the light's");
}

// The part that both highlights share; name is that of the cosine. An eye behind the surface does
// not see a highlight, and an answer that says so is also right.
static void law_of_highlight(Color yours, double ks, double shine, Color light, const char *name)
{
    double low = law_facts()[0], high = law_facts()[1], cosine = law_facts()[2];
    char what[480];
    if (color_not_finite(yours) || fabs(low) < enough || fabs(cosine) < enough || high < enough)
        return;
    if (low < 0) {
        is_black(yours, "the light is behind the surface");
    } else if (cosine < 0) {
        snprintf(what, sizeof what, "the cosine of %s is negative, %s", name,
                 number_text_to(cosine, 4).s);
        is_black(yours, what);
    } else {
        snprintf(what, sizeof what, "ks times %s, the cosine of %s, to the power of %s",
                 number_text_to(cosine, 6).s, name, number_text_to(shine, 6).s);
        is_share(yours, ks * pow(cosine, shine), what, light, "the light's");
    }
}

LAW(phong_term)
{
    law_of_highlight(yours, ks, shine, light, "mirrored light and eye");
}

LAW(halfway_term)
{
    law_of_highlight(yours, ks, shine, light, "normal and halfway vector");
}

// Laws of light in a scene: what hides it, and how it adds up. They judge an answer by the right
// answers to its parts, and are silent if rounding, or how far a right answer goes off its surface,
// may decide.

// ---- visibility ---------------------------------------------------------------------------------

// Whether rounding may decide if there is a hit at t: at either end of the way, or at the edge.
static bool is_doubtful(Ray ray, double reach, Sphere sphere, double t)
{
    vec3 away = ray.origin - sphere.center;
    double foot = -vec3_dot(away, ray.direction) / vec3_dot(ray.direction, ray.direction);
    double close = 1e-6 * sphere.radius;
    double margin = close / vec3_length(ray.direction);
    return fabs(vec3_length(away + foot * ray.direction) - sphere.radius) < close ||
           fabs(vec3_length(away) - sphere.radius) < 1e-9 * sphere.radius ||
           (t < NO_HIT && fabs(t - reach) < margin);
}

LAW(visibility)
{
    const double *to_light = law_facts(), *hits = to_light + 3;
    Ray ray = {from, vec3_of(to_light[0], to_light[1], to_light[2])};
    double reach = light.kind == LIGHT_POINT ? 1 : NO_HIT;
    if (yours != 0 && yours != 1) {
        law_broken("you return %s: a light arrives or does not, 1 or 0", number_text(yours).s);
        return;
    }
    bool doubtful = false;
    for (int i = 0; i < scene->sphere_count; i++) {
        if (is_doubtful(ray, reach, scene->spheres[i], hits[i])) {
            doubtful = true;
        } else if (hits[i] < reach) {
            if (yours != 0)
                law_broken("you return 1, but on the way to the light sphere %d is hit at t = %s%s",
                           i, number_text(hits[i]).s,
                           light.kind == LIGHT_POINT ? "; the light is at t = 1" : "");
            return;
        }
    }
    if (yours == 0 && !doubtful)
        law_broken("you return 0, but none of the %d spheres is between the point and the light",
                   scene->sphere_count);
}

// ---- shade, trace_ray ---------------------------------------------------------------------------

static bool close_to(Color yours, Color right, double tolerance)
{
    bool close = true;
    for (int i = 0; i < 3; i++)
        close = close && fabs(yours[i] - right[i]) <= tolerance * (1 + fabs(right[i]));
    return close;
}

static Color color_fact(int i)
{
    const double *facts = law_facts() + i;
    return vec3_of(facts[0], facts[1], facts[2]);
}

LAW(shade)
{
    const double tolerance = 1e-8;
    Color ambient = color_fact(0);
    if (close_to(yours, right, tolerance))
        return;
    for (int i = 0, count = scene->light_count; i < count; i++) {
        Color gives = color_fact(3 + 3 * i);
        if (close_to(gives, vec3_of(0, 0, 0), tolerance))
            continue;
        if (close_to(yours, right - gives, tolerance))
            law_broken("in your color light %d is missing: it arrives, and adds %s", i,
                       vec3_text(gives).s);
        else if (close_to(yours, right + gives, tolerance))
            law_broken("in your color light %d is counted twice", i);
    }
    Apart both = apart_vec3(yours, right);
    if (close_to(yours, right - ambient, tolerance))
        law_broken("in your color the ambient light is missing: it adds %s", vec3_text(ambient).s);
    else
        law_broken("your color is %s. Ambient light adds %s, and the lights that arrive %s",
                   both.yours.s, vec3_text(ambient).s, vec3_text(right - ambient).s);
}

LAW(trace_ray)
{
    // The color in a mirror depends on how far off its surface a ray starts.
    const double tolerance = 1e-5;
    Color own = color_fact(0);
    int sphere = (int)law_facts()[3];
    if (close_to(yours, right, tolerance))
        return;
    if (sphere < 0) {
        law_broken("the ray hits nothing, so its color is the background's, %s; yours is %s",
                   vec3_text(scene->background).s, vec3_text(yours).s);
        return;
    }
    double ks = scene_surface(scene, sphere)->specular;
    if (depth <= 0 || ks == 0)
        law_broken("the ray hits sphere %d, %s: so its color is that of shade, %s; yours is %s",
                   sphere, ks == 0 ? "which is not a mirror" : "and depth is 0", vec3_text(own).s,
                   vec3_text(yours).s);
    else
        law_broken("the ray hits sphere %d. shade returns %s, the mirrored ray sees %s, and ks is "
                   "%s; your color is %s",
                   sphere, vec3_text(own).s, vec3_text((right - own) / ks).s, number_text(ks).s,
                   vec3_text(yours).s);
}
