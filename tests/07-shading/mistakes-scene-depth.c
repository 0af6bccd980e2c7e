// mistakes-scene-depth.c - wrong answers to trace_ray: how many mirrors deep, and which surfaces
// mirror.
#include "tests/07-shading/mistakes-scene.h"

// Right, except that the mirrored ray has another depth, or something else in its place.
typedef Color Rest(const Scene *scene, Ray mirrored, int depth);

static Color trace_once(Rest *rest, bool mirrors, const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere < 0)
        return scene->background;
    Color color = shade(scene, ray, hit);
    double ks = scene_surface(scene, hit.sphere)->specular;
    if (!mirrors || ks == 0)
        return color;
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = normal_turned(sphere, point, ray);
    Ray mirrored = {off_surface(sphere, point, normal), mirror_direction(ray.direction, normal)};
    return color + ks * rest(scene, mirrored, depth - 1);
}

static Color sky(const Scene *scene, Ray ray, int depth)
{
    (void)ray, (void)depth;
    return scene->background;
}

static Color surface_color(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    (void)depth;
    return hit.sphere < 0 ? scene->background : scene_surface(scene, hit.sphere)->color;
}

// ---- how deep -----------------------------------------------------------------------------------

// Without a limit it ends where it leaves the scene. Between mirrors it would go on until the stack
// overflows; here as long as any of it is visible.
static Color without_a_limit(const Scene *scene, Ray ray, int depth)
{
    enum { AS_GOOD_AS_ENDLESS = 200 };
    (void)depth;
    return trace_ray(scene, ray, AS_GOOD_AS_ENDLESS);
}

static Color one_too_deep(const Scene *scene, Ray ray, int depth)
{
    return trace_ray(scene, ray, depth + 1);
}

static Color one_too_few(const Scene *scene, Ray ray, int depth)
{
    return trace_ray(scene, ray, depth > 0 ? depth - 1 : 0);
}

static Color two_at_a_time(const Scene *scene, Ray ray, int depth)
{
    return trace_once(two_at_a_time, depth > 0, scene, ray, depth - 1);
}

static Color half_of_it(const Scene *scene, Ray ray, int depth)
{
    return trace_once(half_of_it, depth > 0, scene, ray, (depth + 1) / 2);
}

static Color always_one(const Scene *scene, Ray ray, int depth)
{
    (void)depth;
    return trace_ray(scene, ray, 1);
}

static Color at_most_one(const Scene *scene, Ray ray, int depth)
{
    return trace_ray(scene, ray, depth > 0 ? 1 : 0);
}

static Color at_least_one(const Scene *scene, Ray ray, int depth)
{
    return trace_ray(scene, ray, depth > 0 ? depth : 1);
}

static Color no_mirrors(const Scene *scene, Ray ray, int depth)
{
    (void)depth;
    return trace_ray(scene, ray, 0);
}

static Color at_most_five(const Scene *scene, Ray ray, int depth)
{
    return trace_ray(scene, ray, depth < 5 ? depth : 5);
}

// Reversed: the deeper, the less is left.
static Color only_at_depth_0(const Scene *scene, Ray ray, int depth)
{
    return trace_ray(scene, ray, depth == 0 ? 1 : 0);
}

// ---- at the end ---------------------------------------------------------------------------------

static Color black_at_depth_0(const Scene *scene, Ray ray, int depth)
{
    return depth == 0 ? vec3_of(0, 0, 0) : trace_once(black_at_depth_0, true, scene, ray, depth);
}

static Color background_at_depth_0(const Scene *scene, Ray ray, int depth)
{
    return depth == 0 ? scene->background
                      : trace_once(background_at_depth_0, true, scene, ray, depth);
}

static Color background_behind_the_last(const Scene *scene, Ray ray, int depth)
{
    return trace_once(depth > 0 ? background_behind_the_last : sky, true, scene, ray, depth);
}

static Color flat_at_the_end(const Scene *scene, Ray ray, int depth)
{
    return trace_once(depth > 1 ? flat_at_the_end : surface_color, depth > 0, scene, ray, depth);
}

static Color background_for_the_dull(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere >= 0 && scene_surface(scene, hit.sphere)->specular == 0)
        return scene->background;
    return trace_once(background_for_the_dull, depth > 0, scene, ray, depth);
}

static Color black_for_the_dull(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere >= 0 && scene_surface(scene, hit.sphere)->specular == 0)
        return vec3_of(0, 0, 0);
    return trace_once(black_for_the_dull, depth > 0, scene, ray, depth);
}

// ---- which surfaces -----------------------------------------------------------------------------

// The ks of the first hit is used for all mirrors after it.
static Color share_of_the_first(double ks, const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    if (hit.sphere < 0)
        return scene->background;
    Color color = shade(scene, ray, hit);
    ks = ks < 0 ? scene_surface(scene, hit.sphere)->specular : ks;
    if (depth <= 0 || ks == 0)
        return color;
    Sphere sphere = scene->spheres[hit.sphere];
    vec3 point = ray.origin + hit.t * ray.direction;
    vec3 normal = normal_turned(sphere, point, ray);
    Ray mirrored = {off_surface(sphere, point, normal), mirror_direction(ray.direction, normal)};
    return color + ks * share_of_the_first(ks, scene, mirrored, depth - 1);
}

static Color ks_of_the_first(const Scene *scene, Ray ray, int depth)
{
    return share_of_the_first(-1, scene, ray, depth);
}

static Color ks_of_sphere_0(const Scene *scene, Ray ray, int depth)
{
    return scene->sphere_count == 0
               ? scene->background
               : share_of_the_first(scene_surface(scene, 0)->specular, scene, ray, depth);
}

static Color strong_mirrors_only(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    bool strong = hit.sphere >= 0 && scene_surface(scene, hit.sphere)->specular >= 0.5;
    return trace_once(strong_mirrors_only, depth > 0 && strong, scene, ray, depth);
}

static Color perfect_mirrors_only(const Scene *scene, Ray ray, int depth)
{
    Hit hit = nearest_hit(ray, scene);
    bool perfect = hit.sphere >= 0 && scene_surface(scene, hit.sphere)->specular >= 1;
    return trace_once(perfect_mirrors_only, depth > 0 && perfect, scene, ray, depth);
}

const Mistake mirror_depth_mistakes[] = {
    MISTAKE("T-endless", trace_ray, without_a_limit, "no end at depth 0",
            "between two mirrors a ray goes to and fro for ever. If depth is 0, return the colour "
            "of shade.",
            "no visible difference, until two mirrors face each other: a stack overflow"),
    MISTAKE("T-deep", trace_ray, one_too_deep, "a mirrored ray at depth 0 as well",
            "depth > 0, not >= 0: at 0 there are no more mirrors.",
            "mirror images in mirrors once too often"),
    MISTAKE("T-shallow", trace_ray, one_too_few, "no mirrored ray at depth 1",
            "depth > 0, not > 1: at 1 there is one more mirror.",
            "mirror images in mirrors once too few"),
    MISTAKE("T-two", trace_ray, two_at_a_time, "depth - 2 at each mirror",
            "each mirror subtracts 1. Do you subtract it twice?",
            "mirror images in mirrors half as deep"),
    MISTAKE("T-halved", trace_ray, half_of_it, "depth halved at each mirror",
            "each mirror subtracts 1 from it.", "mirror images in mirrors not deep enough"),
    MISTAKE("T-one", trace_ray, always_one, "depth 1, whatever the argument is",
            "depth is the number of mirrors, one after the other.", "no mirrors in mirrors"),
    MISTAKE("T-once-only", trace_ray, at_most_one, "depth 0 for the mirrored ray",
            "it has depth - 1 left.", "no mirrors in mirrors"),
    MISTAKE("T-least", trace_ray, at_least_one, "a mirror at depth 0 as well, but no deeper",
            "at depth 0 there are no mirrors: return the colour of shade.",
            "mirrors where there should be none"),
    MISTAKE("T-0", trace_ray, no_mirrors, "shade only",
            "if depth > 0 and the surface has specular, add what the mirrored ray sees.",
            "no mirrors"),
    MISTAKE("T-5", trace_ray, at_most_five, "a depth of at most 5",
            "the caller may ask for a greater depth: depth alone says where it ends.",
            "the deepest mirrors missing"),
    MISTAKE("T-until", trace_ray, only_at_depth_0, "mirrors only at depth 0",
            "depth is the number of mirrors that are left: it must be more than 0.",
            "mirrors only where there should be none"),
    MISTAKE("T-black0", trace_ray, black_at_depth_0, "black at depth 0",
            "at depth 0 there are no mirrors, but the surfaces are still there: shade.",
            "black; in mirrors black holes"),
    MISTAKE("T-sky0", trace_ray, background_at_depth_0, "the background at depth 0",
            "at depth 0 there are no mirrors, but the surfaces are still there: shade.",
            "nothing but background; mirrors show only the sky"),
    MISTAKE("T-sky-behind", trace_ray, background_behind_the_last,
            "ks times the background at depth 0", "at depth 0 return the colour of shade.",
            "the deepest mirrors too bright"),
    MISTAKE("T-flat-end", trace_ray, flat_at_the_end, "flat colours in the last mirror",
            "objects in a mirror are lit like all others: call trace_ray with depth - 1.",
            "flat spheres in mirrors"),
    MISTAKE("T-dull-sky", trace_ray, background_for_the_dull, "the background if ks is 0",
            "a surface without a mirror is still there, and lit: shade.", "dull objects vanish"),
    MISTAKE("T-dull-black", trace_ray, black_for_the_dull, "black if ks is 0",
            "a surface without a mirror is still there, and lit: shade.", "dull objects are black"),
    MISTAKE("T-ks-first", trace_ray, ks_of_the_first, "the first mirror's ks for all",
            "each surface has its own ks.", "mirrors in mirrors too strong or too weak"),
    MISTAKE("T-ks-0", trace_ray, ks_of_sphere_0, "the ks of sphere 0 for all",
            "each surface has its own ks: use that of the sphere that is hit.",
            "all mirrors are alike"),
    MISTAKE("T-strong", trace_ray, strong_mirrors_only, "mirrors only if ks is at least 0.5",
            "a weak mirror is also a mirror: its specular is not 0.", "weak mirrors do not mirror"),
    MISTAKE("T-perfect", trace_ray, perfect_mirrors_only, "mirrors only if ks is 1",
            "a weak mirror is also a mirror: its specular is not 0.", "hardly any mirrors"),
    {0},
};
