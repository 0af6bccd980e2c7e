// mistakes-scene-seen.c - wrong answers to trace_ray: how much of the mirrored colour is added, and
// which colour that is.
#include "tests/07-shading/mistakes-mirror.h"

static double all_of_it(const Surface *surface)
{
    return surface->specular == 0 ? 0 : 1;
}

static double diffuse_of(const Surface *surface)
{
    return surface->specular == 0 ? 0 : surface->diffuse;
}

static double what_is_not_diffuse(const Surface *surface)
{
    return surface->specular == 0 ? 0 : 1 - surface->diffuse;
}

static double squared(const Surface *surface)
{
    return surface->specular * surface->specular;
}

static Color blended(Color own, double share, Color seen, const Surface *surface)
{
    (void)surface;
    return (1 - share) * own + share * seen;
}

static Color in_the_color(Color own, double share, Color seen, const Surface *surface)
{
    return own + share * surface->color * seen;
}

static Color only_what_is_seen(Color own, double share, Color seen, const Surface *surface)
{
    (void)own, (void)surface;
    return share * seen;
}

static Color of_both(Color own, double share, Color seen, const Surface *surface)
{
    (void)surface;
    return share * (own + seen);
}

static Color multiplied(Color own, double share, Color seen, const Surface *surface)
{
    (void)share, (void)surface;
    return own * seen;
}

static Color mean(Color own, double share, Color seen, const Surface *surface)
{
    (void)share, (void)surface;
    return (own + seen) / 2;
}

static Color clamped(Color own, double share, Color seen, const Surface *surface)
{
    Color sum = plus_share(own, share, seen, surface);
    for (int i = 0; i < 3; i++)
        sum[i] = fmin(1, sum[i]);
    return sum;
}

static Color seen_clamped(Color own, double share, Color seen, const Surface *surface)
{
    for (int i = 0; i < 3; i++)
        seen[i] = fmin(1, seen[i]);
    return plus_share(own, share, seen, surface);
}

static Color black_in_mirrors(const Scene *scene, bool mirrored)
{
    return mirrored ? vec3_of(0, 0, 0) : scene->background;
}

static Color always_black(const Scene *scene, bool mirrored)
{
    (void)scene, (void)mirrored;
    return vec3_of(0, 0, 0);
}

static Color ambient_of_the_scene(const Scene *scene, bool mirrored)
{
    (void)mirrored;
    return scene->ambient;
}

static Color flat(const Scene *scene, Ray ray, Hit hit)
{
    (void)ray;
    return scene_surface(scene, hit.sphere)->color;
}

static Color ambient_only(const Scene *scene, Ray ray, Hit hit)
{
    const Surface *surface = scene_surface(scene, hit.sphere);
    (void)ray;
    return ambient_term(surface->color, surface->diffuse, scene->ambient);
}

static Color without_highlight(const Scene *scene, Ray ray, Hit hit)
{
    const Surface *surface = scene_surface(scene, hit.sphere);
    Sphere sphere = scene->spheres[hit.sphere];
    Color sum = ambient_only(scene, ray, hit);
    vec3 point = ray.origin + hit.t * ray.direction, normal = normal_turned(sphere, point, ray);
    for (int i = 0; i < scene->light_count; i++) {
        Light light = scene->lights[i];
        Color color = light.color * visibility(scene, off_surface(sphere, point, normal), light);
        sum += diffuse_term(surface->color, surface->diffuse, color, normal,
                            ray_to_light(point, light).direction);
    }
    return sum;
}

static Color turned_away(const Scene *scene, Ray ray, Hit hit)
{
    const Surface *s = scene_surface(scene, hit.sphere);
    Sphere sphere = scene->spheres[hit.sphere];
    Color sum = ambient_only(scene, ray, hit);
    vec3 point = ray.origin + hit.t * ray.direction, normal = -normal_turned(sphere, point, ray);
    for (int i = 0; i < scene->light_count; i++) {
        Light light = scene->lights[i];
        Color color = light.color * visibility(scene, off_surface(sphere, point, normal), light);
        vec3 to_light = ray_to_light(point, light).direction;
        sum += diffuse_term(s->color, s->diffuse, color, normal, to_light) +
               phong_term(s->specular, s->shine, color, normal, to_light, -ray.direction);
    }
    return sum;
}

MIRROR(without_ks, .share = all_of_it)
MIRROR(kd_for_ks, .share = diffuse_of)
MIRROR(rest_of_kd, .share = what_is_not_diffuse)
MIRROR(ks_squared, .share = squared)
MIRROR(blended_with_ks, .sum = blended)
MIRROR(in_the_surface_color, .sum = in_the_color)
MIRROR(own_color_lost, .sum = only_what_is_seen)
MIRROR(own_color_times_ks, .sum = of_both)
MIRROR(colors_multiplied, .sum = multiplied)
MIRROR(mean_of_both, .sum = mean)
MIRROR(sum_clamped, .sum = clamped)
MIRROR(mirror_clamped, .sum = seen_clamped)
MIRROR(no_background_in_mirrors, .nothing = black_in_mirrors)
MIRROR(no_background, .nothing = always_black)
MIRROR(ambient_for_background, .nothing = ambient_of_the_scene)
MIRROR(flat_colors, .own = flat)
MIRROR(no_lights, .own = ambient_only)
MIRROR(no_highlights, .own = without_highlight)
MIRROR(lit_from_behind, .own = turned_away)

const Mistake seen_mistakes[] = {
    MISTAKE("T-ks", trace_ray, without_ks, "all of the mirrored colour",
            "specular says how much of it comes back.", "every shiny object a perfect mirror"),
    MISTAKE("T-kd", trace_ray, kd_for_ks, "kd times the mirrored colour",
            "kd belongs to the diffuse term; the mirror has ks.",
            "bright objects mirror, whether shiny or not"),
    MISTAKE("T-rest", trace_ray, rest_of_kd, "1 - kd times the mirrored colour",
            "kd + ks need not be 1: the surface has its own ks.", "mirrors too strong or too weak"),
    MISTAKE("T-square", trace_ray, ks_squared, "ks times ks of the mirrored colour",
            "each mirror multiplies by its ks once.", "mirrors too weak"),
    MISTAKE("T-blend", trace_ray, blended_with_ks, "(1 - ks) times shade + ks times the mirror",
            "kd and ks already say how much there is of each; keep the whole colour of shade.",
            "shiny objects too dark"),
    MISTAKE("T-color", trace_ray, in_the_surface_color, "the mirror in the surface's colour",
            "here mirrors are like highlights: they do not change the colour.",
            "mirrors as if of coloured metal"),
    MISTAKE("T-only", trace_ray, own_color_lost, "ks times the mirror, without shade",
            "the surface still reflects its lights: add the colour of shade.",
            "shiny objects without their own colour"),
    MISTAKE("T-both", trace_ray, own_color_times_ks, "ks times (shade + the mirror)",
            "the colour of shade has its kd and ks already; multiply only the mirror.",
            "shiny objects too dark"),
    MISTAKE("T-times", trace_ray, colors_multiplied, "shade times the mirror",
            "light adds up: add the two colours.", "shiny objects too dark"),
    MISTAKE("T-mean", trace_ray, mean_of_both, "the mean of shade and the mirror",
            "specular says how much of the mirror is added.", "all mirrors are alike"),
    MISTAKE("T-clamp", trace_ray, sum_clamped, "the sum, at most 1",
            "colours are clamped only at the very end, by clamp_color; in the next mirror this one "
            "may be just right.",
            "dull highlights in mirrors"),
    MISTAKE("T-clamp-seen", trace_ray, mirror_clamped, "the mirrored colour, at most 1",
            "colours are clamped only at the very end, by clamp_color; in a mirror this one may be "
            "just right.",
            "dull highlights in mirrors"),
    MISTAKE("T-black", trace_ray, no_background_in_mirrors,
            "black instead of the background in mirrors",
            "a mirrored ray that hits nothing sees the background, like any other.",
            "mirrors too dark where they show the sky"),
    MISTAKE("T-night", trace_ray, no_background, "black if nothing is hit",
            "the scene has its own background colour.", "everything on black"),
    MISTAKE("T-ambient-sky", trace_ray, ambient_for_background,
            "the ambient light if nothing is hit",
            "the scene has both, and they differ: use its background.", "a grey background"),
    MISTAKE("T-flat", trace_ray, flat_colors, "flat colours",
            "a surface that is hit is lit: shade.", "flat spheres with mirror images"),
    MISTAKE("T-ambient", trace_ray, no_lights, "ambient light only",
            "a surface that is hit is lit by every light that arrives: shade.",
            "dark spheres with mirror images"),
    MISTAKE("T-highlight", trace_ray, no_highlights, "shade without highlights",
            "the highlight is the mirror image of the lamp, which no ray can hit. Keep it.",
            "mirrors without highlights"),
    MISTAKE("T-away", trace_ray, lit_from_behind, "shade with the normal turned away from the eye",
            "the lit side is the one that the eye sees, and the normal points to that side.",
            "dark spheres with mirror images"),
    {0},
};
