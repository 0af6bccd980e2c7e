// laws-scene.c - laws of light in a scene: what hides it, and how it adds up.
//
// They judge an answer by the right answers to its parts, and are silent if rounding, or how far a
// right answer goes off its surface, may decide.
#include "tests/07-shading/laws.h"

#include "exercises/05-quadratic.h"
#include "exercises/06-ray-casting.h"
#include "tests/judge/reference/distinct_digits.h"

// ---- off_surface --------------------------------------------------------------------------------

void law_off_surface(vec3 yours, Sphere sphere, vec3 point, vec3 normal)
{
    vec3 c = sphere.center, moved = yours - point;
    double size = sphere.radius + fmax(fabs(c[0]), fmax(fabs(c[1]), fabs(c[2])));
    double along = vec3_dot(moved, normal), aside = vec3_length(moved - along * normal);
    double least = 0x1p-32 * size, most = 0x1p-28 * size, rounding = 0x1p-40 * size;
    if (!vec3_is_finite(yours))
        law_broken("your point is %s", vec3_text(yours).s);
    else if (!(aside <= rounding) && aside > fabs(along))
        law_broken("your point is %s away from the given one, and not along the normal",
                   number_text_to(vec3_length(moved), 3).s);
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

void law_visibility(double yours, const Scene *scene, vec3 from, Light light)
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

void law_shade(Color yours, const Scene *scene, Ray ray, Hit hit)
{
    const double tolerance = 1e-8;
    Color right = shade(scene, ray, hit), ambient = with_lights(scene, ray, hit, 0, 0);
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

void law_trace_ray(Color yours, const Scene *scene, Ray ray, int depth)
{
    // The colour in a mirror depends on how far off its surface a ray starts.
    const double tolerance = 1e-5;
    Color right = trace_ray(scene, ray, depth);
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
