// mistakes-shadow-spheres.c - wrong answers to visibility: which spheres, and the return value.
#include "tests/07-shading/mistakes-scene.h"

static double visible_if(bool visible)
{
    return visible ? 1 : 0;
}

static bool hides(const Scene *scene, int i, vec3 from, Light light)
{
    return hit_sphere(ray_to_light(from, light), scene->spheres[i]) < reach_of(light);
}

// The number of spheres from first up to end, without that one.
static int count_hiding(const Scene *scene, int first, int end, vec3 from, Light light)
{
    int count = 0;
    for (int i = first; i < end; i++)
        count += hides(scene, i, from, light);
    return count;
}

// ---- which sphere, and which of its roots -------------------------------------------------------

// The result of the loop counts only for the last sphere.
static double last_sphere_only(const Scene *scene, vec3 from, Light light)
{
    bool visible = true;
    for (int i = 0; i < scene->sphere_count; i++)
        visible = !hides(scene, i, from, light);
    return visible_if(visible);
}

static double first_sphere_only(const Scene *scene, vec3 from, Light light)
{
    return visible_if(count_hiding(scene, 0, scene->sphere_count > 0, from, light) == 0);
}

static double all_spheres_needed(const Scene *scene, vec3 from, Light light)
{
    int count = scene->sphere_count;
    return visible_if(count == 0 || count_hiding(scene, 0, count, from, light) < count);
}

static double without_first(const Scene *scene, vec3 from, Light light)
{
    return visible_if(count_hiding(scene, 1, scene->sphere_count, from, light) == 0);
}

static double without_last(const Scene *scene, vec3 from, Light light)
{
    return visible_if(count_hiding(scene, 0, scene->sphere_count - 1, from, light) == 0);
}

// Of some sphere, the near root (0) or the far one (1).
static bool any_root(const Scene *scene, int which, Ray ray, double least, double reach)
{
    for (int i = 0; i < scene->sphere_count; i++) {
        Roots roots = sphere_roots(ray, scene->spheres[i]);
        if (roots.count > 0 && roots.t[which] > least && roots.t[which] < reach)
            return true;
    }
    return false;
}

#define SHADOW_OF_ROOTS(name, which, least, reach)                                                 \
    static double name(const Scene *scene, vec3 from, Light light)                                 \
    {                                                                                              \
        return visible_if(!any_root(scene, which, ray_to_light(from, light), least, reach));       \
    }

SHADOW_OF_ROOTS(behind_the_place_too, 0, -INFINITY, reach_of(light))
SHADOW_OF_ROOTS(anywhere_on_the_line, 0, -INFINITY, INFINITY)
SHADOW_OF_ROOTS(spheres_entered_only, 0, 0, reach_of(light))
SHADOW_OF_ROOTS(spheres_left_only, 1, 0, reach_of(light))

static double by_centres(const Scene *scene, vec3 from, Light light)
{
    Ray ray = ray_to_light(from, light);
    for (int i = 0; i < scene->sphere_count; i++) {
        double away = vec3_length(scene->spheres[i].center - from) / vec3_length(ray.direction);
        if (hit_sphere(ray, scene->spheres[i]) < NO_HIT && away < reach_of(light))
            return 0;
    }
    return 1;
}

// ---- other answers ------------------------------------------------------------------------------

static double inverted(const Scene *scene, vec3 from, Light light)
{
    return 1 - visibility(scene, from, light);
}

static double always_lit(const Scene *scene, vec3 from, Light light)
{
    (void)scene, (void)from, (void)light;
    return 1;
}

static double always_dark(const Scene *scene, vec3 from, Light light)
{
    (void)scene, (void)from, (void)light;
    return 0;
}

static double half_in_shadow(const Scene *scene, vec3 from, Light light)
{
    return visibility(scene, from, light) > 0 ? 1 : 0.5;
}

static double half_for_each(const Scene *scene, vec3 from, Light light)
{
    return ldexp(1, -count_hiding(scene, 0, scene->sphere_count, from, light));
}

static double less_one_for_each(const Scene *scene, vec3 from, Light light)
{
    return 1 - count_hiding(scene, 0, scene->sphere_count, from, light);
}

static double through_glass(const Scene *scene, vec3 from, Light light)
{
    double visible = 1;
    for (int i = 0; i < scene->sphere_count; i++)
        if (hides(scene, i, from, light))
            visible *= scene_surface(scene, i)->transmittance;
    return visible;
}

static double t_of_the_hit(const Scene *scene, vec3 from, Light light)
{
    Hit hit = nearest_hit(ray_to_light(from, light), scene);
    return hit.t < reach_of(light) ? hit.t : 1;
}

const Mistake shadow_sphere_mistakes[] = {
    MISTAKE("V-last", visibility, last_sphere_only, "only the last sphere",
            "each sphere overwrites what was found before. One that hides the light is enough: "
            "return at once.",
            "shadows of one sphere only"),
    MISTAKE("V-first", visibility, first_sphere_only, "only the first sphere",
            "if the first does not hide the light, another one may: only after the loop you know "
            "that none does.",
            "shadows of one sphere only"),
    MISTAKE("V-all", visibility, all_spheres_needed, "0 only if every sphere is in between",
            "one sphere in between is enough.", "hardly any shadow"),
    MISTAKE("V-from1", visibility, without_first, "sphere 0 left out",
            "spheres are counted from 0.", "the first sphere casts no shadow"),
    MISTAKE("V-but-last", visibility, without_last, "the last sphere left out",
            "counted from 0, the last of n spheres has the index n - 1, and it must be tested.",
            "the last sphere casts no shadow"),
    MISTAKE("V-behind", visibility, behind_the_place_too,
            "near roots with t < 1, even negative ones",
            "a hit with t < 0 is on the other side of the point, away from the light.",
            "objects behind a surface cast shadows on it"),
    MISTAKE("V-line", visibility, anywhere_on_the_line,
            "any root, even behind the point or the light", "in between means 0 < t < 1.",
            "far too many shadows"),
    MISTAKE("R8-shadow", visibility, spheres_entered_only, "near roots only",
            "from inside a sphere the near root is behind the point, but the way to a light "
            "outside still hits the far side.",
            "light inside closed spheres"),
    MISTAKE("R6-shadow", visibility, spheres_left_only, "far roots only",
            "a light inside a sphere is hidden by the side where the ray enters.",
            "lamps that shine out of closed spheres"),
    MISTAKE("V-centre", visibility, by_centres,
            "hits of spheres whose centre is nearer than the light",
            "light and point may be in front of a sphere's centre, or inside it. The hit on its "
            "surface counts.",
            "parts of shadows missing near lamps"),
    MISTAKE("V-inverted", visibility, inverted, "1 in the shadow, 0 in the light",
            "the return value is the share of the light that arrives: 0 if a sphere is in between.",
            "light only where shadows should be"),
    MISTAKE("V-1", visibility, always_lit, "1", "spheres in between hide the light.", "no shadows"),
    MISTAKE("V-0", visibility, always_dark, "0",
            "if no sphere is in between, all of the light arrives.", "no light at all"),
    MISTAKE("V-half", visibility, half_in_shadow, "1/2 in the shadow",
            "none of this light arrives there. Shadows are not black because of the ambient light.",
            "pale shadows"),
    MISTAKE("V-halves", visibility, half_for_each, "half for each sphere in between",
            "one is enough to hide the light, and more spheres hide no more than that.",
            "pale shadows, darker where they overlap"),
    MISTAKE("V-less", visibility, less_one_for_each, "minus 1 for each sphere in between",
            "light cannot be negative: with two spheres in between this is below 0.",
            "shadows too dark where they overlap"),
    MISTAKE("V-glass", visibility, through_glass,
            "times the transmittance of the spheres in between",
            "here any sphere hides the light, glass as well as stone.", "pale shadows of glass"),
    MISTAKE("V-t", visibility, t_of_the_hit, "t of the hit",
            "the return value is 0 or 1. The distance of the sphere in between does not matter.",
            "shadows with a gradient"),
    {0},
};
