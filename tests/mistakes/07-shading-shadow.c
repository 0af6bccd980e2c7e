// 07-shading-shadow.c - wrong answers to visibility.
#include "tests/mistakes/07-shading-scene.h"

// ---- one loop, and what may slip in it ----------------------------------------------------------

static double reach_of(Light light)
{
    return light.kind == LIGHT_DISTANT ? NO_HIT : 1;
}

static double visible_if(bool visible)
{
    return visible ? 1 : 0;
}

static bool is_hidden(const Scene *scene, Ray ray, double least, double reach)
{
    for (int i = 0; i < scene->sphere_count; i++) {
        double t = hit_sphere(ray, scene->spheres[i]);
        if (t > least && t < reach)
            return true;
    }
    return false;
}

#define SHADOW(name, ray, least, reach)                                                            \
    static double name(const Scene *scene, vec3 from, Light light)                                 \
    {                                                                                              \
        return visible_if(!is_hidden(scene, ray, least, reach));                                   \
    }

static Ray unit_ray(vec3 from, Light light)
{
    Ray ray = ray_to_light(from, light);
    return (Ray){from, vec3_unit(ray.direction)};
}

static double way_to(vec3 from, Light light)
{
    return vec3_length(ray_to_light(from, light).direction);
}

static Ray reversed(vec3 from, Light light)
{
    return (Ray){from, -ray_to_light(from, light).direction};
}

static Ray from_the_light(vec3 from, Light light)
{
    vec3 way = ray_to_light(from, light).direction;
    return (Ray){from + way, -way};
}

SHADOW(beyond_the_light, ray_to_light(from, light), 0, NO_HIT)
SHADOW(reach_1_for_all, ray_to_light(from, light), 0, 1)
SHADOW(unit_and_reach_1, unit_ray(from, light), 0, reach_of(light))
SHADOW(t_against_the_distance, ray_to_light(from, light), 0, way_to(from, light))
SHADOW(way_reversed, reversed(from, light), 0, reach_of(light))
SHADOW(place_not_subtracted, ((Ray){from, light.position}), 0, reach_of(light))
SHADOW(place_always_subtracted, ((Ray){from, light.position - from}), 0, reach_of(light))
SHADOW(distant_as_point, ((Ray){from, light.position - from}), 0, 1)
SHADOW(from_the_origin_of_the_world, ((Ray){from - from, light.position}), 0, reach_of(light))
SHADOW(place_for_direction, ((Ray){light.position, from}), 0, reach_of(light))
SHADOW(beyond_the_place, from_the_light(from, light), 0, NO_HIT)
SHADOW(hits_from_a_thousandth, ray_to_light(from, light), 1e-3, reach_of(light))
SHADOW(hits_from_a_ten_thousandth, ray_to_light(from, light), 1e-4, reach_of(light))
SHADOW(hits_from_a_hundred_thousandth, ray_to_light(from, light), 1e-5, reach_of(light))
SHADOW(hits_from_a_millionth, ray_to_light(from, light), 1e-6, reach_of(light))
SHADOW(up_to_a_thousandth, ray_to_light(from, light), 0, (1 - 1e-3) * reach_of(light))
SHADOW(up_to_a_ten_thousandth, ray_to_light(from, light), 0, (1 - 1e-4) * reach_of(light))
SHADOW(only_beyond, ray_to_light(from, light), reach_of(light), NO_HIT)

// ---- which sphere, and which of its roots -------------------------------------------------------

// What the loop says of each sphere counts only for the last.
static double last_sphere_only(const Scene *scene, vec3 from, Light light)
{
    double visible = 1;
    for (int i = 0; i < scene->sphere_count; i++)
        visible =
            hit_sphere(ray_to_light(from, light), scene->spheres[i]) < reach_of(light) ? 0 : 1;
    return visible;
}

static double first_sphere_only(const Scene *scene, vec3 from, Light light)
{
    for (int i = 0; i < scene->sphere_count; i++)
        return hit_sphere(ray_to_light(from, light), scene->spheres[i]) < reach_of(light) ? 0 : 1;
    return 1;
}

static double all_spheres_needed(const Scene *scene, vec3 from, Light light)
{
    for (int i = 0; i < scene->sphere_count; i++)
        if (!(hit_sphere(ray_to_light(from, light), scene->spheres[i]) < reach_of(light)))
            return 1;
    return visible_if(scene->sphere_count == 0);
}

static double without_first(const Scene *scene, vec3 from, Light light)
{
    for (int i = 1; i < scene->sphere_count; i++)
        if (hit_sphere(ray_to_light(from, light), scene->spheres[i]) < reach_of(light))
            return 0;
    return 1;
}

static double without_last(const Scene *scene, vec3 from, Light light)
{
    for (int i = 0; i + 1 < scene->sphere_count; i++)
        if (hit_sphere(ray_to_light(from, light), scene->spheres[i]) < reach_of(light))
            return 0;
    return 1;
}

// The first root of each, where it is before the light; behind the place too.
static double behind_the_place_too(const Scene *scene, vec3 from, Light light)
{
    for (int i = 0; i < scene->sphere_count; i++) {
        Roots roots = sphere_roots(ray_to_light(from, light), scene->spheres[i]);
        if (roots.count > 0 && roots.t[0] < reach_of(light))
            return 0;
    }
    return 1;
}

static double anywhere_on_the_line(const Scene *scene, vec3 from, Light light)
{
    for (int i = 0; i < scene->sphere_count; i++)
        if (sphere_roots(ray_to_light(from, light), scene->spheres[i]).count > 0)
            return 0;
    return 1;
}

static double spheres_entered_only(const Scene *scene, vec3 from, Light light)
{
    for (int i = 0; i < scene->sphere_count; i++) {
        Roots roots = sphere_roots(ray_to_light(from, light), scene->spheres[i]);
        if (roots.count > 0 && roots.t[0] > 0 && roots.t[0] < reach_of(light))
            return 0;
    }
    return 1;
}

static double spheres_left_only(const Scene *scene, vec3 from, Light light)
{
    for (int i = 0; i < scene->sphere_count; i++) {
        Roots roots = sphere_roots(ray_to_light(from, light), scene->spheres[i]);
        if (roots.count > 0 && roots.t[1] > 0 && roots.t[1] < reach_of(light))
            return 0;
    }
    return 1;
}

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
    double visible = 1;
    for (int i = 0; i < scene->sphere_count; i++)
        if (hit_sphere(ray_to_light(from, light), scene->spheres[i]) < reach_of(light))
            visible /= 2;
    return visible;
}

static double less_one_for_each(const Scene *scene, vec3 from, Light light)
{
    double visible = 1;
    for (int i = 0; i < scene->sphere_count; i++)
        visible -= hit_sphere(ray_to_light(from, light), scene->spheres[i]) < reach_of(light);
    return visible;
}

static double through_glass(const Scene *scene, vec3 from, Light light)
{
    double visible = 1;
    for (int i = 0; i < scene->sphere_count; i++)
        if (hit_sphere(ray_to_light(from, light), scene->spheres[i]) < reach_of(light))
            visible *= scene_surface(scene, i)->transmittance;
    return visible;
}

static double t_of_the_hit(const Scene *scene, vec3 from, Light light)
{
    Hit hit = nearest_hit(ray_to_light(from, light), scene);
    return hit.t < reach_of(light) ? hit.t : 1;
}

const Mistake shadow_mistakes[] = {
    MISTAKE("V-beyond", visibility, beyond_the_light, "any hit at all",
            "a point light stands at t = 1 of its ray, and what is behind it is not in its way.",
            "shadows of things behind the lamp"),
    MISTAKE("V-reach1", visibility, reach_1_for_all, "hits with t < 1, of a distant light too",
            "t = 1 is only where its direction's tip is; the light itself is beyond everything.",
            "in sunlight only what is very close casts a shadow"),
    MISTAKE("V-unit", visibility, unit_and_reach_1, "hits with t < 1, of a direction of length 1",
            "then the point light is at t = its distance. Along the way as it is, it is at t = 1.",
            "shadows of things behind the lamp, or hardly any"),
    MISTAKE("V-distance", visibility, t_against_the_distance, "hits with t < |l - p|",
            "t counts in lengths of the direction, which is as long as the way to the light: it is "
            "at t = 1.",
            "shadows of things behind the lamp"),
    MISTAKE("V-reversed", visibility, way_reversed, "the ray away from the light",
            "from the place to the light it is l - p, and what is on the other side of the place "
            "is in nobody's way.",
            "shadows on the wrong side"),
    MISTAKE("V-minus", visibility, place_not_subtracted, "direction l, of a point light too",
            "l is a place. The way to it from p is l - p.",
            "shadows in one direction, as in the sun, and at wrong places"),
    MISTAKE("V-always-minus", visibility, place_always_subtracted,
            "direction l - p, of a distant light too",
            "a distant light is in the same direction from everywhere: what is given is that "
            "direction.",
            "shadows in the sun that spread as from a lamp"),
    MISTAKE("V-lamp", visibility, distant_as_point, "a distant light like a point light",
            "a distant light has no place: its direction is given, and nothing is behind it.",
            "shadows in the sun that spread as from a lamp"),
    MISTAKE("V-origin", visibility, from_the_origin_of_the_world, "the ray from the world's origin",
            "whether the light arrives is asked at p.", "everything dark or everything lit"),
    MISTAKE("V-swapped", visibility, place_for_direction, "origin l, direction p",
            "a ray has a place to start from, p, and a direction, l - p.",
            "shadows here and there, without any sense"),
    MISTAKE("V-through", visibility, beyond_the_place, "any hit of the ray from the light",
            "what is behind the place is not between the two: 0 < t < 1 only.",
            "what stands in front of something is dark as well"),
    MISTAKE("V-1e-3", visibility, hits_from_a_thousandth, "hits with t > 0.001",
            "what is close to the surface casts a shadow, too. p is off its surface already: t > "
            "0.",
            "light under things that stand on a surface"),
    MISTAKE("V-1e-4", visibility, hits_from_a_ten_thousandth, "hits with t > 1e-4",
            "what is close to the surface casts a shadow, too. p is off its surface already: t > "
            "0.",
            "light under things that stand on a surface"),
    MISTAKE("V-1e-5", visibility, hits_from_a_hundred_thousandth, "hits with t > 1e-5",
            "what is close to the surface casts a shadow, too. p is off its surface already: t > "
            "0.",
            "light under small things that stand on a surface"),
    MISTAKE("V-1e-6", visibility, hits_from_a_millionth, "hits with t > 1e-6",
            "what is close to the surface casts a shadow, too. p is off its surface already: t > "
            "0.",
            "light under small things that stand on a surface"),
    MISTAKE("V-0.999", visibility, up_to_a_thousandth, "hits with t < 0.999",
            "the light is at t = 1, and what is close before it hides it.",
            "a lamp that shines through its own shade"),
    MISTAKE("V-0.9999", visibility, up_to_a_ten_thousandth, "hits with t < 0.9999",
            "the light is at t = 1, and what is close before it hides it.",
            "a lamp that shines through its own shade"),
    MISTAKE("V-only-beyond", visibility, only_beyond, "hits with t > 1",
            "those are behind the light. In between is what has 0 < t < 1.",
            "shadows of things behind the lamp, and of nothing else"),
    MISTAKE("V-last", visibility, last_sphere_only, "what the last sphere says",
            "each sphere overwrites what was found out before. One that hides the light is enough: "
            "return at once.",
            "shadows of one sphere only"),
    MISTAKE("V-first", visibility, first_sphere_only, "what the first sphere says",
            "if the first does not hide the light, another one may: only after the loop it is "
            "known that none does.",
            "shadows of one sphere only"),
    MISTAKE("V-all", visibility, all_spheres_needed, "0 where every sphere is in between",
            "one sphere in between is enough.", "hardly any shadow"),
    MISTAKE("V-from1", visibility, without_first, "sphere 0 left out",
            "spheres are counted from 0.", "the first sphere casts no shadow"),
    MISTAKE("V-but-last", visibility, without_last, "the last sphere left out",
            "counted from 0, the last of n spheres has the index n - 1, and it is one of them.",
            "the last sphere casts no shadow"),
    MISTAKE("V-behind", visibility, behind_the_place_too,
            "near roots with t < 1, negative ones too",
            "what has t < 0 is on the other side of the place, away from the light.",
            "things behind a surface cast shadows on it"),
    MISTAKE("V-line", visibility, anywhere_on_the_line, "any root, also behind the place or light",
            "in between is where 0 < t < 1.", "far too many shadows"),
    MISTAKE("R8-shadow", visibility, spheres_entered_only, "near roots only",
            "from inside a sphere the near root is behind the place, but the way to a light "
            "outside still meets the sphere where it leaves it.",
            "light inside closed spheres"),
    MISTAKE("R6-shadow", visibility, spheres_left_only, "far roots only",
            "a light inside a sphere is hidden by the side where its ray comes in.",
            "lamps that shine out of closed spheres"),
    MISTAKE("V-centre", visibility, by_centres, "hits of spheres whose centre is before the light",
            "light and place may be before a sphere's centre, or inside it. Where the surface is "
            "hit counts.",
            "parts of shadows missing near lamps"),
    MISTAKE("V-inverted", visibility, inverted, "1 in the shadow, 0 in the light",
            "it is how much of the light arrives: 0 where a sphere is in between.",
            "light only where shadows should be"),
    MISTAKE("V-1", visibility, always_lit, "1", "spheres in between hide the light.", "no shadows"),
    MISTAKE("V-0", visibility, always_dark, "0",
            "where no sphere is in between, all of the light arrives.", "no light at all"),
    MISTAKE("V-half", visibility, half_in_shadow, "1/2 in the shadow",
            "nothing of this light arrives there. That shadows are not black comes from ambient "
            "light.",
            "pale shadows"),
    MISTAKE("V-halves", visibility, half_for_each, "half for each sphere in between",
            "one is enough to hide the light, and more of them hide no more than that.",
            "pale shadows, darker where they overlap"),
    MISTAKE("V-less", visibility, less_one_for_each, "1 less for each sphere in between",
            "below 0 nothing can arrive: behind two spheres that is negative light.",
            "shadows too dark where they overlap"),
    MISTAKE("V-glass", visibility, through_glass, "times the transmittance of what is in between",
            "here any sphere hides the light, glass like stone.", "pale shadows of glass"),
    MISTAKE("V-t", visibility, t_of_the_hit, "t of the hit",
            "0 or 1 is asked for. How far away the sphere in between is does not matter.",
            "shadows with a gradient"),
    {0},
};
