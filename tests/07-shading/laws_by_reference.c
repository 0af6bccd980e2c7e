// laws_by_reference.c - the laws of exercise 07 that need the steps of the answer: shares of light,
// and what is lit.
#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "exercises/07-shading.h"

#include "tests/judge/law.h"

// Ten times what the contract allows.
static const double enough = 1e-8;

static const char *const names[] = {"red", "green", "blue"};

// ---- laws of the terms: the share of each light that comes back, colour by colour ---------------

static bool color_not_finite(Color color)
{
    for (int i = 0; i < 3; i++)
        if (!isfinite(color[i])) {
            law_broken("your %s is not a finite number", names[i]);
            return true;
        }
    return false;
}

// The share, in each colour; 'of' names the whole.
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

static double cosine_between(vec3 v, vec3 w)
{
    return vec3_dot(v, w) / (vec3_length(v) * vec3_length(w));
}

LAW(ambient_term)
{
    if (!color_not_finite(yours))
        is_share(yours, kd, "kd", surface * ambient, "the surface's times the light's");
}

LAW(diffuse_term)
{
    double cosine = cosine_between(normal, to_light);
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
static void law_of_highlight(Color yours, double ks, double shine, Color light, double low,
                             double high, double cosine, const char *name)
{
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
    double low = cosine_between(normal, to_light), high = cosine_between(normal, to_eye);
    double cosine = 2 * low * high - cosine_between(to_light, to_eye);
    law_of_highlight(yours, ks, shine, light, low, high, cosine, "mirrored light and eye");
}

LAW(halfway_term)
{
    double low = cosine_between(normal, to_light), high = cosine_between(normal, to_eye);
    double length = sqrt(2 + 2 * cosine_between(to_light, to_eye)); // of the sum of both
    if (length > 1e-3)
        law_of_highlight(yours, ks, shine, light, low, high, (low + high) / length,
                         "normal and half-way vector");
}

// Laws of light in a scene: what hides it, and how it adds up. They judge an answer by the right
// answers to its parts, and are silent if rounding, or how far a right answer goes off its surface,
// may decide.

// ---- visibility ---------------------------------------------------------------------------------

// Whether rounding may decide if there is a hit: at either end of the way, or at the edge.
static bool is_doubtful(Ray ray, double reach, Sphere sphere)
{
    vec3 away = ray.origin - sphere.center;
    double foot = -vec3_dot(away, ray.direction) / vec3_dot(ray.direction, ray.direction);
    double close = 1e-6 * sphere.radius, t = hit_sphere(ray, sphere);
    double margin = close / vec3_length(ray.direction);
    return fabs(vec3_length(away + foot * ray.direction) - sphere.radius) < close ||
           fabs(vec3_length(away) - sphere.radius) < 1e-9 * sphere.radius ||
           (t < NO_HIT && fabs(t - reach) < margin);
}

LAW(visibility)
{
    Ray ray = ray_to_light(from, light);
    double reach = light.kind == LIGHT_DISTANT ? NO_HIT : 1;
    if (yours != 0 && yours != 1) {
        law_broken("you return %s: a light arrives or does not, 1 or 0", number_text(yours).s);
        return;
    }
    bool doubtful = false;
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (is_doubtful(ray, reach, scene->spheres[i])) {
            doubtful = true;
        } else if (t < reach) {
            if (yours != 0)
                law_broken("you return 1, but on the way to the light sphere %d is hit at t = %s%s",
                           i, number_text(t).s,
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

// The ambient part alone, and what each light adds to it.
static Color with_lights(const Scene *scene, Ray ray, Hit hit, int first, int end)
{
    Scene some = *scene;
    some.lights += first;
    some.light_count = end - first;
    return shade(&some, ray, hit);
}

LAW(shade)
{
    const double tolerance = 1e-8;
    Color ambient = with_lights(scene, ray, hit, 0, 0);
    if (close_to(yours, right, tolerance))
        return;
    for (int i = 0; i < scene->light_count; i++) {
        Color gives = with_lights(scene, ray, hit, i, i + 1) - ambient;
        if (close_to(gives, vec3_of(0, 0, 0), tolerance))
            continue;
        if (close_to(yours, right - gives, tolerance))
            law_broken("in your colour light %d is missing: it arrives, and adds %s", i,
                       vec3_text(gives).s);
        else if (close_to(yours, right + gives, tolerance))
            law_broken("in your colour light %d is counted twice", i);
    }
    Apart both = apart_vec3(yours, right);
    if (close_to(yours, right - ambient, tolerance))
        law_broken("in your colour the ambient light is missing: it adds %s", vec3_text(ambient).s);
    else
        law_broken("your colour is %s. Ambient light adds %s, and the lights that arrive %s",
                   both.yours.s, vec3_text(ambient).s, vec3_text(right - ambient).s);
}

LAW(trace_ray)
{
    // The colour in a mirror depends on how far off its surface a ray starts.
    const double tolerance = 1e-5;
    Hit hit = nearest_hit(ray, scene);
    if (close_to(yours, right, tolerance))
        return;
    if (hit.sphere < 0) {
        law_broken("the ray hits nothing, so its colour is the background's, %s; yours is %s",
                   vec3_text(scene->background).s, vec3_text(yours).s);
        return;
    }
    Color own = shade(scene, ray, hit);
    double ks = scene_surface(scene, hit.sphere)->specular;
    if (depth <= 0 || ks == 0)
        law_broken("the ray hits sphere %d, %s: so its colour is that of shade, %s; yours is %s",
                   hit.sphere, ks == 0 ? "which is not a mirror" : "and depth is 0",
                   vec3_text(own).s, vec3_text(yours).s);
    else
        law_broken("the ray hits sphere %d. shade returns %s, the mirrored ray sees %s, and ks is "
                   "%s; your colour is %s",
                   hit.sphere, vec3_text(own).s, vec3_text((right - own) / ks).s, number_text(ks).s,
                   vec3_text(yours).s);
}
