// mistakes-light.c - wrong rays to the light.
#include "tests/07-shading/mistakes.h"

static bool is_point(Light light)
{
    return light.kind == LIGHT_POINT;
}

// The right direction, for mistakes that change it.
static vec3 way(vec3 from, Light light)
{
    return is_point(light) ? light.position - from : light.position;
}

static Ray from_light_to_surface(vec3 from, Light light)
{
    return (Ray){from, -way(from, light)};
}

static Ray point_reversed(vec3 from, Light light)
{
    return (Ray){from, is_point(light) ? from - light.position : light.position};
}

static Ray distant_reversed(vec3 from, Light light)
{
    return (Ray){from, is_point(light) ? light.position - from : -light.position};
}

static Ray all_distant(vec3 from, Light light)
{
    return (Ray){from, light.position};
}

static Ray all_point(vec3 from, Light light)
{
    return (Ray){from, light.position - from};
}

static Ray all_point_reversed(vec3 from, Light light)
{
    return (Ray){from, from - light.position};
}

static Ray kinds_swapped(vec3 from, Light light)
{
    return (Ray){from, is_point(light) ? light.position : light.position - from};
}

static Ray all_unit(vec3 from, Light light)
{
    return (Ray){from, vec3_unit(way(from, light))};
}

static Ray point_unit(vec3 from, Light light)
{
    return (Ray){from, is_point(light) ? vec3_unit(light.position - from) : light.position};
}

static Ray distant_unit(vec3 from, Light light)
{
    return (Ray){from, is_point(light) ? light.position - from : vec3_unit(light.position)};
}

static Ray starts_at_the_light(vec3 from, Light light)
{
    return (Ray){light.position, -way(from, light)};
}

static Ray starts_at_the_point_light(vec3 from, Light light)
{
    return (Ray){is_point(light) ? light.position : from,
                 is_point(light) ? from - light.position : light.position};
}

static Ray starts_at_the_light_and_leaves(vec3 from, Light light)
{
    return (Ray){light.position, way(from, light)};
}

static Ray starts_at_the_origin(vec3 from, Light light)
{
    return (Ray){vec3_of(0, 0, 0), way(from, light)};
}

static Ray added(vec3 from, Light light)
{
    return (Ray){from, is_point(light) ? light.position + from : light.position};
}

static Ray point_of_the_distant(vec3 from, Light light)
{
    return (Ray){from, is_point(light) ? light.position - from : light.position + from};
}

static Ray vector_and_point_swapped(vec3 from, Light light)
{
    return (Ray){way(from, light), from};
}

static Ray a_bit_ahead(vec3 from, Light light)
{
    return (Ray){from + 0.001 * way(from, light), way(from, light)};
}

static Ray a_unit_bit_ahead(vec3 from, Light light)
{
    return (Ray){from + 0.001 * vec3_unit(way(from, light)), way(from, light)};
}

const Mistake light_mistakes[] = {
    MISTAKE("S2-ray", ray_to_light, from_light_to_surface, "the direction from the light",
            "it must point towards the light: the end minus the start.",
            "spheres lit on the far side"),
    MISTAKE("S2-point", ray_to_light, point_reversed, "from - position, of a point light",
            "this leads from the light to the surface. The end minus the start: position - from.",
            "spheres lit on the side away from a point light"),
    MISTAKE("S2-distant", ray_to_light, distant_reversed, "-position, of a distant light",
            "scene.h says that a distant light lies in that direction, so it already points "
            "towards the light.",
            "spheres lit on the side away from the sun"),
    MISTAKE("LI-distant", ray_to_light, all_distant, "position, for both kinds",
            "the direction to a point light depends on the start.",
            "lamps that light like the sun: the same side of every sphere"),
    MISTAKE("LI-point", ray_to_light, all_point, "position - from, for both kinds",
            "a distant light has no place. It has a direction, the same from everywhere.",
            "a sun that is as near as a lamp"),
    MISTAKE("S2-all-point", ray_to_light, all_point_reversed, "from - position, for both kinds",
            "this points away from a point light; and a distant one has no place at all.",
            "spheres lit on the far side"),
    MISTAKE("LI-kinds", ray_to_light, kinds_swapped, "the kinds swapped",
            "LIGHT_POINT is the light at a position.",
            "lamps that light like the sun, and a sun like a lamp"),
    MISTAKE("LI-unit", ray_to_light, all_unit, "the direction normalised",
            "then t = 1 is not the light any more, and a search for spheres in between uses the "
            "wrong range of t.",
            "shadows that are missing, or cast by spheres behind the light"),
    MISTAKE("LI-unit-point", ray_to_light, point_unit, "(position - from) / |position - from|",
            "then t = 1 is not the light any more, and a search for spheres in between uses the "
            "wrong range of t.",
            "shadows that are missing, or cast by spheres behind the light"),
    MISTAKE(
        "LI-unit-distant", ray_to_light, distant_unit, "position / |position|, of a distant one",
        "the direction is right, but the contract asks for the light's own direction, unchanged.",
        "no visible difference; the terms normalise it anyway"),
    MISTAKE("LI-back", ray_to_light, starts_at_the_light, "from the light to the point",
            "the ray starts at the point and leads to the light. From a distant light no ray can "
            "start.",
            "spheres lit on the far side"),
    MISTAKE("LI-back-point", ray_to_light, starts_at_the_point_light,
            "from the point light to the point",
            "the same segment, but reversed: the ray starts at the point, and t = 1 is the light.",
            "spheres lit on the far side"),
    MISTAKE("LI-start", ray_to_light, starts_at_the_light_and_leaves, "an origin at the light",
            "the ray starts at the given point, from.", "shadows in odd places"),
    MISTAKE("LI-origin", ray_to_light, starts_at_the_origin, "an origin of (0, 0, 0)",
            "the ray starts at the given point, from.", "everything in shadow, or nothing"),
    MISTAKE("LI-plus", ray_to_light, added, "position + from",
            "the vector from one point to another is the end minus the start.",
            "spheres lit from wrong sides, worse the farther they are from the origin"),
    MISTAKE("LI-place", ray_to_light, point_of_the_distant, "from + position, of a distant light",
            "this is a point on the way, not a direction.",
            "a sun in another place for every sphere"),
    MISTAKE("LI-swapped", ray_to_light, vector_and_point_swapped, "origin and direction swapped",
            "the origin is a point, where the ray starts; the direction is a difference of points.",
            "light and shadow in odd places"),
    MISTAKE("LI-ahead", ray_to_light, a_bit_ahead, "an origin 0.001 of the way ahead",
            "the caller gives the point, and off_surface has already moved it as far as needed.",
            "shadows that start a little beside their spheres"),
    MISTAKE("LI-ahead-unit", ray_to_light, a_unit_bit_ahead, "an origin 0.001 ahead",
            "the caller gives the point, and off_surface has already moved it as far as needed. In "
            "a tiny scene 0.001 is a long way.",
            "tiny scenes without shadows"),
    {0},
};
