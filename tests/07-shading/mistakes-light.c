// mistakes-light.c - wrong ways to the light.
#include "tests/07-shading/mistakes.h"

static bool is_point(Light light)
{
    return light.kind == LIGHT_POINT;
}

// The right direction, to be spoiled.
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
            "it must lead towards the light: the end less the beginning.",
            "spheres lit on the far side"),
    MISTAKE("S2-point", ray_to_light, point_reversed, "from - position, of a point light",
            "that leads from the light to the surface. The end less the beginning: position - "
            "from.",
            "spheres lit on the side that is away from a point light"),
    MISTAKE("S2-distant", ray_to_light, distant_reversed, "-position, of a distant light",
            "scene.h says that a distant light lies in that direction, so it is already the way "
            "towards it.",
            "spheres lit on the side that is away from the sun"),
    MISTAKE("LI-distant", ray_to_light, all_distant, "position, whatever the kind",
            "the way to a point light depends on where one starts.",
            "lamps that light like the sun: the same side of every sphere"),
    MISTAKE("LI-point", ray_to_light, all_point, "position - from, whatever the kind",
            "a distant light has no place. What it has is a direction, the same from everywhere.",
            "a sun that is as near as a lamp"),
    MISTAKE("S2-all-point", ray_to_light, all_point_reversed, "from - position, whatever the kind",
            "that leads away from a point light; and a distant one has no place at all.",
            "spheres lit on the far side"),
    MISTAKE("LI-kinds", ray_to_light, kinds_swapped, "the kinds exchanged",
            "LIGHT_POINT is the one that stands at its position.",
            "lamps that light like the sun, and a sun like a lamp"),
    MISTAKE("LI-unit", ray_to_light, all_unit, "the direction made unit",
            "then t = 1 is not the light any more, and who looks for what is in between looks at "
            "the wrong stretch.",
            "shadows that are missing, or cast by what stands behind the light"),
    MISTAKE("LI-unit-point", ray_to_light, point_unit, "(position - from) / |position - from|",
            "then t = 1 is not the light any more, and who looks for what is in between looks at "
            "the wrong stretch.",
            "shadows that are missing, or cast by what stands behind the light"),
    MISTAKE("LI-unit-distant", ray_to_light, distant_unit,
            "position / |position|, of a distant one",
            "it goes the right way, but the contract says: the light's own direction, as it is.",
            "nothing; the terms make it unit anyway"),
    MISTAKE("LI-back", ray_to_light, starts_at_the_light, "from the light to the place",
            "the ray begins at the place and leads to the light. From a distant light none can "
            "begin.",
            "spheres lit on the far side"),
    MISTAKE("LI-back-point", ray_to_light, starts_at_the_point_light,
            "from the point light to the place",
            "the same stretch, but the other way: the ray begins at the place, and t = 1 is the "
            "light.",
            "spheres lit on the far side"),
    MISTAKE("LI-start", ray_to_light, starts_at_the_light_and_leaves, "an origin in the light",
            "the ray begins at the place that asks for light.", "shadows in odd places"),
    MISTAKE("LI-origin", ray_to_light, starts_at_the_origin, "an origin of (0, 0, 0)",
            "the ray begins at the place that asks for light.", "everything in shadow, or nothing"),
    MISTAKE("LI-plus", ray_to_light, added, "position + from",
            "the way from one place to another is the end less the beginning.",
            "spheres lit from odd sides, worse the farther they are from the origin"),
    MISTAKE("LI-place", ray_to_light, point_of_the_distant, "from + position, of a distant light",
            "that is a place on the way, not a direction.",
            "a sun that stands elsewhere for every sphere"),
    MISTAKE("LI-swapped", ray_to_light, vector_and_point_swapped, "origin and direction exchanged",
            "the origin is where the ray begins, a place; the direction is a difference.",
            "light and shadow in odd places"),
    MISTAKE("LI-ahead", ray_to_light, a_bit_ahead, "an origin 0.001 of the way ahead",
            "the place is given by whoever asks, and off_surface has moved it as far as needed.",
            "shadows that begin a little beside what casts them"),
    MISTAKE("LI-ahead-unit", ray_to_light, a_unit_bit_ahead, "an origin 0.001 ahead",
            "the place is given by whoever asks, and off_surface has moved it as far as needed. In "
            "a tiny scene 0.001 is a long way.",
            "tiny scenes without shadows"),
    {0},
};
