// mistakes-shadow.c - wrong answers to visibility: the ray, and which hits count.
#include "tests/07-shading/mistakes-scene.h"

// ---- one loop, and what may slip in it ----------------------------------------------------------

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
    {0},
};
