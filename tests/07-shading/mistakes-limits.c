// mistakes-limits.c - wrong answers to exercise 07: limits that no scene and no light has, and
// fields of a surface that are swapped.
#include "tests/07-shading/mistakes-scene.h"
#include "tests/07-shading/mistakes.h"

#include <limits.h>

// ---- terms --------------------------------------------------------------------------------------

static double cosine_of(vec3 v, vec3 w)
{
    return vec3_dot(v, w) / (vec3_length(v) * vec3_length(w));
}

#define DIFFUSE_FROM(name, least)                                                                  \
    static Color name(Color surface, double kd, Color light, vec3 n, vec3 l)                       \
    {                                                                                              \
        return cosine_of(n, l) < (least) ? grey(0) : diffuse_term(surface, kd, light, n, l);       \
    }
DIFFUSE_FROM(diffuse_from_1e_2, 1e-2)
DIFFUSE_FROM(diffuse_from_1e_3, 1e-3)
DIFFUSE_FROM(diffuse_from_1e_6, 1e-6)

// Both highlights: with another ks or shine, or nothing at all.
#define HIGHLIGHT(name, ...)                                                                       \
    static Color phong_##name(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)        \
    {                                                                                              \
        double low = cosine_of(n, l);                                                              \
        (void)low;                                                                                 \
        __VA_ARGS__;                                                                               \
        return phong_term(ks, shine, light, n, l, e);                                              \
    }                                                                                              \
    static Color halfway_##name(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)      \
    {                                                                                              \
        double low = cosine_of(n, l);                                                              \
        (void)low;                                                                                 \
        __VA_ARGS__;                                                                               \
        return halfway_term(ks, shine, light, n, l, e);                                            \
    }
HIGHLIGHT(black_without_shine, if (shine == 0) return grey(0))
HIGHLIGHT(shine_at_least_1, shine = fmax(1, shine))
HIGHLIGHT(shine_at_most_10, shine = fmin(10, shine))
HIGHLIGHT(shine_at_most_100, shine = fmin(100, shine))
HIGHLIGHT(shine_at_most_128, shine = fmin(128, shine))
HIGHLIGHT(shine_at_most_1000, shine = fmin(1000, shine))
HIGHLIGHT(shine_rounded, shine = floor(shine + 0.5))
HIGHLIGHT(ks_and_shine, double kept = ks; ks = shine; shine = kept)
// The cosine on which a highlight depends, and all of it if that is nearly 1.
static Color phong_all_near_the_middle(double ks, double shine, Color light, vec3 n, vec3 l, vec3 e)
{
    vec3 mirrored = 2 * vec3_dot(n, l) * n - l;
    bool near = cosine_of(mirrored, e) > 0.999999 && vec3_dot(n, l) > 0;
    return near ? ks * light : phong_term(ks, shine, light, n, l, e);
}
static Color halfway_all_near_the_middle(double ks, double shine, Color light, vec3 n, vec3 l,
                                         vec3 e)
{
    vec3 between = l / vec3_length(l) + e / vec3_length(e);
    bool near = cosine_of(between, n) > 0.999999 && vec3_dot(n, l) > 0;
    return near ? ks * light : halfway_term(ks, shine, light, n, l, e);
}

HIGHLIGHT(low_from_1e_3, if (low < 1e-3) return grey(0))
HIGHLIGHT(low_from_1e_6, if (low < 1e-6) return grey(0))

#define BOTH(id, slip, formula, why, picture)                                                      \
    MISTAKE("PH-" id, phong_term, phong_##slip, formula, why, picture),                            \
        MISTAKE("HW-" id, halfway_term, halfway_##slip, formula, why, picture)
#define AT_MOST(number)                                                                            \
    BOTH("most" #number, shine_at_most_##number, "a shine of at most " #number,                    \
         "a polished surface may have any shine.", "highlights of polished surfaces too large")

const Mistake term_limit_mistakes[] = {
    MISTAKE("DI-1e-2", diffuse_term, diffuse_from_1e_2, "nothing if n.l is below 0.01",
            "a low light gives little, but not nothing: only below 0 it gives nothing.",
            "a dark edge before the shadow starts"),
    MISTAKE("DI-1e-3", diffuse_term, diffuse_from_1e_3, "nothing if n.l is below 0.001",
            "a low light gives little, but not nothing: only below 0 it gives nothing.",
            "hardly anything"),
    MISTAKE("DI-1e-6", diffuse_term, diffuse_from_1e_6, "nothing if n.l is below 1e-6",
            "a low light gives little, but not nothing: only below 0 it gives nothing.",
            "hardly anything"),
    BOTH(
        "near1", all_near_the_middle, "all of ks if the cosine is above 0.999999",
        "with a high shine the highlight is already weaker there: raise every cosine to the power.",
        "a flat spot in the middle of small highlights"),
    BOTH("shine0", black_without_shine, "nothing if shine is 0",
         "any number to the power of 0 is 1: with a shine of 0 all of ks is seen.",
         "no highlight where it should be widest"),
    BOTH("shine1", shine_at_least_1, "a shine of at least 1",
         "a shine below 1 makes the highlight wider still: use it unchanged.",
         "highlights of dull surfaces too small"),
    AT_MOST(10),
    AT_MOST(100),
    AT_MOST(128),
    AT_MOST(1000),
    BOTH("rounded", shine_rounded, "shine rounded to an integer",
         "shine is a double, and need not be a whole number: pow accepts any.",
         "highlights a little too large or too small"),
    BOTH("ks-shine", ks_and_shine, "ks and shine swapped",
         "shine is the power, ks multiplies the result. Look at the order of the arguments.",
         "wide highlights, and too bright"),
    BOTH("1e-3", low_from_1e_3, "nothing if n.l is below 0.001",
         "a low light also makes a highlight: only below 0 there is none.",
         "highlights cut off at edges"),
    BOTH("1e-6", low_from_1e_6, "nothing if n.l is below 1e-6",
         "a low light also makes a highlight: only below 0 there is none.", "hardly anything"),
    {0},
};

// ---- one of three -------------------------------------------------------------------------------

// Right for some of the three numbers, and unchanged for the others.
static vec3 where(bool x, bool y, bool z, vec3 right, vec3 as_it_was)
{
    return vec3_of(x ? right[0] : as_it_was[0], y ? right[1] : as_it_was[1],
                   z ? right[2] : as_it_was[2]);
}

#define ONLY(name, x, y, z)                                                                        \
    static Color clamped_##name(Color c)                                                           \
    {                                                                                              \
        return where(x, y, z, clamp_color(c), c);                                                  \
    }                                                                                              \
    static Color encoded_##name(Color c, double gamma)                                             \
    {                                                                                              \
        return where(x, y, z, gamma_encode(c, gamma), c);                                          \
    }
ONLY(green, false, true, false)
ONLY(blue, false, false, true)
ONLY(but_red, false, true, true)
ONLY(but_green, true, false, true)

static Color where_all_exceed(Color c)
{
    bool above = c[0] > 1 && c[1] > 1 && c[2] > 1, below = c[0] < 0 && c[1] < 0 && c[2] < 0;
    return above || below ? clamp_color(c) : c;
}

static Color black_where_one_is_below(Color c)
{
    return c[0] < 0 || c[1] < 0 || c[2] < 0 ? grey(0) : clamp_color(c);
}

#define AXIS(name, x, y, z)                                                                        \
    static vec3 normal_##name(Sphere sphere, vec3 point)                                           \
    {                                                                                              \
        return vec3_of(x, y, z) * surface_normal(sphere, point);                                   \
    }                                                                                              \
    static vec3 mirrored_##name(vec3 direction, vec3 normal)                                       \
    {                                                                                              \
        return vec3_of(x, y, z) * mirror_direction(direction, normal);                             \
    }
AXIS(minus_x, -1, 1, 1)
AXIS(minus_y, 1, -1, 1)
AXIS(minus_z, 1, 1, -1)

#define ONLY_ROW(id, name, what)                                                                   \
    MISTAKE("CL-" id, clamp_color, clamped_##name, what " clamped", "all three must fit.",         \
            "speckles of wrong colours in the brightest spots"),                                   \
        MISTAKE("GA-" id, gamma_encode, encoded_##name, what " encoded",                           \
                "the display does the same to all three.", "a picture in false colours")
#define AXIS_ROW(axis)                                                                             \
    MISTAKE("W-minus-" #axis, surface_normal, normal_minus_##axis, #axis " with the wrong sign",   \
            "each coordinate is the point's minus the centre's.",                                  \
            "spheres lit from a wrong side"),                                                      \
        MISTAKE("MI-minus-" #axis, mirror_direction, mirrored_minus_##axis,                        \
                #axis " with the wrong sign", "all three coordinates are v - 2 (v.n) n.",          \
                "mirrors that show the wrong side")

const Mistake shading_axis_mistakes[] = {
    ONLY_ROW("green", green, "only green"),
    ONLY_ROW("blue", blue, "only blue"),
    ONLY_ROW("but-red", but_red, "only green and blue"),
    ONLY_ROW("but-green", but_green, "only red and blue"),
    MISTAKE("CL-and", clamp_color, where_all_exceed, "clamped only if all three do not fit",
            "each number is clamped by itself, whether the others fit or not.",
            "speckles of wrong colours in the brightest spots"),
    MISTAKE("CL-black-below", clamp_color, black_where_one_is_below, "all black if one is below 0",
            "each number is clamped by itself, and the others do not change.",
            "black spots with hard edges"),
    AXIS_ROW(x),
    AXIS_ROW(y),
    AXIS_ROW(z),
    {0},
};

// ---- visibility ---------------------------------------------------------------------------------

static double hidden_between(const Scene *scene, vec3 from, Light light, int most, double least,
                             double reach)
{
    Ray ray = ray_to_light(from, light);
    for (int i = 0; i < scene->sphere_count && i < most; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t > least && t < reach)
            return 0;
    }
    return 1;
}

#define SHADOW(name, most, least, reach)                                                           \
    static double name(const Scene *scene, vec3 from, Light light)                                 \
    {                                                                                              \
        return hidden_between(scene, from, light, most, least, reach);                             \
    }
SHADOW(shadow_of_8, 8, 0, reach_of(light))
SHADOW(shadow_of_10, 10, 0, reach_of(light))
SHADOW(shadow_of_16, 16, 0, reach_of(light))
SHADOW(shadow_of_32, 32, 0, reach_of(light))
SHADOW(shadow_of_64, 64, 0, reach_of(light))
SHADOW(shadow_of_100, 100, 0, reach_of(light))
SHADOW(shadow_of_128, 128, 0, reach_of(light))
SHADOW(shadow_of_256, 256, 0, reach_of(light))
SHADOW(shadow_from_1e_7, INT_MAX, 1e-7, reach_of(light))
SHADOW(shadow_from_1e_8, INT_MAX, 1e-8, reach_of(light))
SHADOW(shadow_from_1e_9, INT_MAX, 1e-9, reach_of(light))
SHADOW(shadow_to_1000, INT_MAX, 0, fmin(1e3, reach_of(light)))
SHADOW(shadow_to_1e6, INT_MAX, 0, fmin(1e6, reach_of(light)))
SHADOW(shadow_to_1e9, INT_MAX, 0, fmin(1e9, reach_of(light)))
SHADOW(shadow_of_points, INT_MAX, 0, light.kind == LIGHT_POINT ? 1 : 0)
SHADOW(shadow_of_distant, INT_MAX, 0, light.kind == LIGHT_POINT ? 0 : NO_HIT)

static double until_one_is_missed(const Scene *scene, vec3 from, Light light)
{
    Ray ray = ray_to_light(from, light);
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t == NO_HIT)
            return 1;
        if (t < reach_of(light))
            return 0;
    }
    return 1;
}

#define SHADOW_ROOM(number)                                                                        \
    MISTAKE("V-room" #number, visibility, shadow_of_##number, "the first " #number " spheres",     \
            "the number of spheres in the scene is sphere_count.",                                 \
            "no visible difference, until a scene has more spheres")
#define SHADOW_FROM(least, answer)                                                                 \
    MISTAKE(                                                                                       \
        "V-" least, visibility, answer, "hits with t > " least,                                    \
        "a sphere close to the surface also casts a shadow. p is off its surface already: t > "    \
        "0.",                                                                                      \
        "light under small objects on a surface")
#define SHADOW_TO(most, answer)                                                                    \
    MISTAKE("V-to-" most, visibility, answer, "of a distant light, hits with t < " most,           \
            "a distant light is beyond everything, and its direction has any length: t of a hit "  \
            "has no upper limit.",                                                                 \
            "in sunlight distant objects cast no shadow")

const Mistake shadow_limit_mistakes[] = {
    SHADOW_ROOM(8),
    SHADOW_ROOM(10),
    SHADOW_ROOM(16),
    SHADOW_ROOM(32),
    SHADOW_ROOM(64),
    SHADOW_ROOM(100),
    SHADOW_ROOM(128),
    SHADOW_ROOM(256),
    SHADOW_FROM("1e-7", shadow_from_1e_7),
    SHADOW_FROM("1e-8", shadow_from_1e_8),
    SHADOW_FROM("1e-9", shadow_from_1e_9),
    SHADOW_TO("1000", shadow_to_1000),
    SHADOW_TO("1e6", shadow_to_1e6),
    SHADOW_TO("1e9", shadow_to_1e9),
    MISTAKE("V-points", visibility, shadow_of_points, "1 for every distant light",
            "a sphere in between hides a distant light like any other.", "no shadows in sunlight"),
    MISTAKE("V-sun", visibility, shadow_of_distant, "1 for every point light",
            "a sphere in between hides a point light like any other.", "no shadows by lamps"),
    MISTAKE("V-break", visibility, until_one_is_missed, "the spheres up to the first miss",
            "a sphere that is missed says nothing about the next one: only after the loop you know "
            "that none is in between.",
            "shadows missing, depending on the order of the scene"),
    {0},
};

// ---- shade --------------------------------------------------------------------------------------

static Color of_lights(const Scene *scene, int most, Ray ray, Hit hit)
{
    Scene some = *scene;
    some.light_count = scene->light_count < most ? scene->light_count : most;
    return shade(&some, ray, hit);
}

#define LIGHTS(number)                                                                             \
    static Color of_##number##_lights(const Scene *scene, Ray ray, Hit hit)                        \
    {                                                                                              \
        return of_lights(scene, number, ray, hit);                                                 \
    }
LIGHTS(4)
LIGHTS(8)
LIGHTS(10)
LIGHTS(16)
LIGHTS(32)

// As if another surface were hit; the ambient term unchanged.
typedef struct {
    double kd, ks, shine;
} Fields;

static Color with_fields(Fields fields, const Scene *scene, Ray ray, Hit hit)
{
    const Surface *s = scene_surface(scene, hit.sphere);
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction, normal = normal_turned(sphere, point, ray);
    Color sum = ambient_term(s->color, s->diffuse, scene->ambient);
    for (int i = 0; i < scene->light_count; i++) {
        Light light = scene->lights[i];
        Color color = light.color * visibility(scene, off_surface(sphere, point, normal), light);
        vec3 l = ray_to_light(point, light).direction;
        sum += diffuse_term(s->color, fields.kd, color, normal, l) +
               phong_term(fields.ks, fields.shine, color, normal, l, -ray.direction);
    }
    return sum;
}

#define FIELDS(name, kd, ks, shine)                                                                \
    static Color name(const Scene *scene, Ray ray, Hit hit)                                        \
    {                                                                                              \
        const Surface *s = scene_surface(scene, hit.sphere);                                       \
        return with_fields((Fields){kd, ks, shine}, scene, ray, hit);                              \
    }
FIELDS(ks_for_shine, s->diffuse, s->specular, s->specular)
FIELDS(shine_for_ks, s->diffuse, s->shine, s->shine)
FIELDS(ks_shine_swapped, s->diffuse, s->shine, s->specular)
FIELDS(kd_for_ks, s->diffuse, s->diffuse, s->shine)
FIELDS(ks_for_kd, s->specular, s->specular, s->shine)
FIELDS(rest_for_ks, s->diffuse, 1 - s->diffuse, s->shine)
FIELDS(rest_for_kd, 1 - s->specular, s->specular, s->shine)

#define LIGHTS_ROW(number)                                                                         \
    MISTAKE("L-room" #number, shade, of_##number##_lights, "the first " #number " lights",         \
            "the number of lights in the scene is light_count.",                                   \
            "no visible difference, until a scene has more lights")
#define FIELDS_ROW(id, name, formula, why)                                                         \
    MISTAKE(id, shade, name, formula, why, "highlights or colours of another surface")

const Mistake shade_limit_mistakes[] = {
    LIGHTS_ROW(4),
    LIGHTS_ROW(8),
    LIGHTS_ROW(10),
    LIGHTS_ROW(16),
    LIGHTS_ROW(32),
    FIELDS_ROW("L-ks-shine", ks_for_shine, "ks instead of shine",
               "ks is the strength of the highlight; shine is the power."),
    FIELDS_ROW("L-shine-ks", shine_for_ks, "shine instead of ks",
               "shine is the power; ks is the strength of the highlight."),
    FIELDS_ROW("L-ks-and-shine", ks_shine_swapped, "ks and shine swapped",
               "phong_term takes ks first, then shine."),
    FIELDS_ROW("L-kd-ks", kd_for_ks, "kd instead of ks",
               "kd belongs to the diffuse term; the highlight has ks, the surface's specular."),
    FIELDS_ROW("L-ks-kd", ks_for_kd, "ks instead of kd",
               "ks belongs to the highlight; the diffuse term has kd, the surface's diffuse."),
    FIELDS_ROW("L-rest-ks", rest_for_ks, "1 - kd instead of ks",
               "kd + ks need not be 1: the surface has its own ks."),
    FIELDS_ROW("L-rest-kd", rest_for_kd, "1 - ks instead of kd",
               "kd + ks need not be 1: the surface has its own kd."),
    {0},
};

// ---- trace_ray ----------------------------------------------------------------------------------

typedef struct {
    int deepest;
    double least_ks, least_share;
} Limits;

static Color trace_with_limits(Limits limits, const Scene *scene, Ray ray, int depth, double share)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere < 0)
        return scene->background;
    Color color = shade(scene, ray, hit);
    double ks = scene_surface(scene, hit.sphere)->specular;
    if (depth <= 0 || limits.deepest <= 0 || ks <= limits.least_ks ||
        share * ks < limits.least_share)
        return color;
    limits.deepest--;
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction, normal = normal_turned(sphere, point, ray);
    Ray mirrored = {off_surface(sphere, point, normal), mirror_direction(ray.direction, normal)};
    return color + ks * trace_with_limits(limits, scene, mirrored, depth - 1, share * ks);
}

#define LIMITED(name, deepest, ks, share)                                                          \
    static Color name(const Scene *scene, Ray ray, int depth)                                      \
    {                                                                                              \
        return trace_with_limits((Limits){deepest, ks, share}, scene, ray, depth, 1);              \
    }
LIMITED(at_most_2, 2, 0, 0)
LIMITED(at_most_3, 3, 0, 0)
LIMITED(at_most_4, 4, 0, 0)
LIMITED(at_most_6, 6, 0, 0)
LIMITED(at_most_8, 8, 0, 0)
LIMITED(at_most_10, 10, 0, 0)
LIMITED(at_most_16, 16, 0, 0)
LIMITED(at_most_20, 20, 0, 0)
LIMITED(at_most_32, 32, 0, 0)
LIMITED(at_most_50, 50, 0, 0)
LIMITED(at_most_100, 100, 0, 0)
LIMITED(ks_from_1e_1, INT_MAX, 0.1, 0)
LIMITED(ks_from_1e_2, INT_MAX, 1e-2, 0)
LIMITED(ks_from_1e_3, INT_MAX, 1e-3, 0)
LIMITED(ks_from_1e_6, INT_MAX, 1e-6, 0)
LIMITED(share_from_1e_2, INT_MAX, 0, 1e-2)
LIMITED(share_from_1e_3, INT_MAX, 0, 1e-3)
LIMITED(share_from_1e_4, INT_MAX, 0, 1e-4)
LIMITED(share_from_1e_6, INT_MAX, 0, 1e-6)

#define DEEPEST_ROW(number)                                                                        \
    MISTAKE("T-most" #number, trace_ray, at_most_##number, "a depth of at most " #number,          \
            "the caller may ask for any depth.",                                                   \
            "no visible difference, until mirrors face each other")
#define KS_ROW(least, name)                                                                        \
    MISTAKE("T-ks-" least, trace_ray, name, "mirrors only if ks is more than " least,              \
            "a weak mirror is also a mirror: its specular is not 0.",                              \
            "weak mirrors do not mirror")
#define SHARE_ROW(least, name)                                                                     \
    MISTAKE("T-share-" least, trace_ray, name,                                                     \
            "mirrors only while more than " least " of them comes through",                        \
            "only depth and ks decide where it ends: the mirrored object may be bright.",          \
            "mirrors in mirrors missing")

const Mistake mirror_limit_mistakes[] = {
    DEEPEST_ROW(2),
    DEEPEST_ROW(3),
    DEEPEST_ROW(4),
    DEEPEST_ROW(6),
    DEEPEST_ROW(8),
    DEEPEST_ROW(10),
    DEEPEST_ROW(16),
    DEEPEST_ROW(20),
    DEEPEST_ROW(32),
    DEEPEST_ROW(50),
    DEEPEST_ROW(100),
    KS_ROW("0.1", ks_from_1e_1),
    KS_ROW("0.01", ks_from_1e_2),
    KS_ROW("0.001", ks_from_1e_3),
    KS_ROW("1e-6", ks_from_1e_6),
    SHARE_ROW("0.01", share_from_1e_2),
    SHARE_ROW("0.001", share_from_1e_3),
    SHARE_ROW("1e-4", share_from_1e_4),
    SHARE_ROW("1e-6", share_from_1e_6),
    {0},
};
