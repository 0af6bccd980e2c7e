// mistakes-shadow.c - wrong answers to visibility: the ray, and which hits count.
#include "tests/07-shading/mistakes-scene.h"

// ---- one loop, and possible slips in it ---------------------------------------------------------

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
    MISTAKE(
        "V-beyond", visibility, beyond_the_light, "any hit at all",
        "a point light is at t = 1 of its ray, and a sphere behind the light is not in its way.",
        "shadows of objects behind the lamp"),
    MISTAKE("V-reach1", visibility, reach_1_for_all, "hits with t < 1, even of a distant light",
            "the tip of its direction is at t = 1; the light itself is beyond everything.",
            "in sunlight only very close objects cast a shadow"),
    MISTAKE("V-unit", visibility, unit_and_reach_1, "hits with t < 1, of a direction of length 1",
            "then the point light is at t = its distance. If you do not normalise the direction, "
            "it is at t = 1.",
            "shadows of objects behind the lamp, or hardly any"),
    MISTAKE("V-distance", visibility, t_against_the_distance, "hits with t < |l - p|",
            "t counts in lengths of the direction, which is as long as the distance of the light: "
            "it is at t = 1.",
            "shadows of objects behind the lamp"),
    MISTAKE("V-reversed", visibility, way_reversed, "the ray away from the light",
            "from the point to the light it is l - p, and a sphere on the other side of the point "
            "is not in the way.",
            "shadows on the wrong side"),
    MISTAKE("V-minus", visibility, place_not_subtracted, "direction l, even of a point light",
            "l is a point. The vector to it from p is l - p.",
            "shadows in one direction, as in the sun, and at wrong places"),
    MISTAKE("V-always-minus", visibility, place_always_subtracted,
            "direction l - p, even of a distant light",
            "a distant light is in the same direction from everywhere: l is that direction.",
            "shadows in the sun that spread as from a lamp"),
    MISTAKE("V-lamp", visibility, distant_as_point, "a distant light like a point light",
            "a distant light has no place: l is its direction, and nothing is behind the light.",
            "shadows in the sun that spread as from a lamp"),
    MISTAKE("V-origin", visibility, from_the_origin_of_the_world, "the ray from the world's origin",
            "test visibility from p: does the light arrive there?",
            "everything dark or everything lit"),
    MISTAKE("V-swapped", visibility, place_for_direction, "origin l, direction p",
            "a ray needs a point to start from, p, and a direction, l - p.",
            "shadows in random places"),
    MISTAKE("V-through", visibility, beyond_the_place, "any hit of the ray from the light",
            "a hit behind the point is not between the two: 0 < t < 1 only.",
            "surfaces with an object behind them are dark as well"),
    MISTAKE(
        "V-1e-3", visibility, hits_from_a_thousandth, "hits with t > 0.001",
        "a sphere close to the surface also casts a shadow. p is off its surface already: t > 0.",
        "light under objects on a surface"),
    MISTAKE(
        "V-1e-4", visibility, hits_from_a_ten_thousandth, "hits with t > 1e-4",
        "a sphere close to the surface also casts a shadow. p is off its surface already: t > 0.",
        "light under objects on a surface"),
    MISTAKE(
        "V-1e-5", visibility, hits_from_a_hundred_thousandth, "hits with t > 1e-5",
        "a sphere close to the surface also casts a shadow. p is off its surface already: t > 0.",
        "light under small objects on a surface"),
    MISTAKE(
        "V-1e-6", visibility, hits_from_a_millionth, "hits with t > 1e-6",
        "a sphere close to the surface also casts a shadow. p is off its surface already: t > 0.",
        "light under small objects on a surface"),
    MISTAKE("V-0.999", visibility, up_to_a_thousandth, "hits with t < 0.999",
            "the light is at t = 1, and a sphere just in front of it hides it.",
            "a lamp that shines through its own shade"),
    MISTAKE("V-0.9999", visibility, up_to_a_ten_thousandth, "hits with t < 0.9999",
            "the light is at t = 1, and a sphere just in front of it hides it.",
            "a lamp that shines through its own shade"),
    MISTAKE("V-only-beyond", visibility, only_beyond, "hits with t > 1",
            "those are behind the light. In between means 0 < t < 1.",
            "shadows of objects behind the lamp, and of no others"),
    {0},
};
