// mistakes-normal.c - wrong normals.
#include "tests/07-shading/mistakes.h"

static vec3 point_made_unit(Sphere s, vec3 point)
{
    (void)s;
    return vec3_unit(point);
}

static vec3 point_through_radius(Sphere s, vec3 point)
{
    return point / s.radius;
}

static vec3 point_as_it_is(Sphere s, vec3 point)
{
    (void)s;
    return point;
}

static vec3 inward(Sphere s, vec3 point)
{
    return vec3_unit(s.center - point);
}

static vec3 inward_not_unit(Sphere s, vec3 point)
{
    return s.center - point;
}

static vec3 not_unit(Sphere s, vec3 point)
{
    return point - s.center;
}

static vec3 through_radius_squared(Sphere s, vec3 point)
{
    return (point - s.center) / (s.radius * s.radius);
}

static vec3 times_radius(Sphere s, vec3 point)
{
    return (point - s.center) * s.radius;
}

static vec3 centre_added(Sphere s, vec3 point)
{
    return vec3_unit(point + s.center);
}

static vec3 radius_subtracted(Sphere s, vec3 point)
{
    return point - s.center - s.radius;
}

static vec3 made_unit_too_early(Sphere s, vec3 point)
{
    return vec3_unit(point) - vec3_unit(s.center);
}

static vec3 through_length_of_point(Sphere s, vec3 point)
{
    return (point - s.center) / vec3_length(point);
}

static vec3 precedence_of_division(Sphere s, vec3 point)
{
    return point - s.center / s.radius;
}

static vec3 by_its_largest(Sphere s, vec3 point)
{
    vec3 v = point - s.center;
    return v / fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

const Mistake normal_mistakes[] = {
    MISTAKE("W2", surface_normal, point_made_unit, "point / |point|",
            "this points away from the origin of the world. A sphere's normal points away from its "
            "own centre.",
            "shading that is right only for a sphere around the origin"),
    MISTAKE("W2-r", surface_normal, point_through_radius, "point / r",
            "a radius leads from the centre to the point, but the centre is missing.",
            "shading that is right only for a sphere around the origin"),
    MISTAKE("W2-point", surface_normal, point_as_it_is, "the point itself",
            "this is the vector from the origin of the world, and its length is arbitrary.",
            "spheres too bright, lit from wrong sides"),
    MISTAKE("W3", surface_normal, inward, "(c - point) / |c - point|",
            "this points into the sphere, to its centre.",
            "dark where it should be light, and light where it should be dark"),
    MISTAKE("W3-length", surface_normal, inward_not_unit, "c - point",
            "this points into the sphere, and is as long as its radius.",
            "dark where it should be light, and light where it should be dark"),
    MISTAKE("W-length", surface_normal, not_unit, "point - c",
            "this is as long as the radius. A normal has length 1; if it is longer, cosines come "
            "out too large.",
            "large spheres too bright, small ones nearly black"),
    MISTAKE("W-squared", surface_normal, through_radius_squared, "(point - c) / r^2",
            "point - c has length r, so dividing by r once normalises it.",
            "small spheres too bright, large ones nearly black"),
    MISTAKE("W-times", surface_normal, times_radius, "(point - c) r",
            "point - c has length r already: divide by r.",
            "large spheres too bright, small ones nearly black"),
    MISTAKE("W-plus", surface_normal, centre_added, "(point + c) / |point + c|",
            "the vector from the centre to the point is the point minus the centre.",
            "spheres lit from wrong sides, worse the farther they are from the origin"),
    MISTAKE("W-scalar", surface_normal, radius_subtracted, "point - c - r",
            "subtracting a number from a vector subtracts it from each component. To make it "
            "shorter, divide.",
            "spheres that are dark from most sides, and too bright from the others"),
    MISTAKE("W-early", surface_normal, made_unit_too_early, "point / |point| - c / |c|",
            "here the lengths are lost before the subtraction. First subtract, then normalise.",
            "nearly black spheres; nothing at all for one around the origin"),
    MISTAKE("W-other", surface_normal, through_length_of_point, "(point - c) / |point|",
            "divide it by its own length, which is |point - c|.",
            "spheres that are darker, the farther they are from the origin"),
    MISTAKE("W-brackets", surface_normal, precedence_of_division, "point - c / r",
            "division comes first, so only c is divided. The difference needs parentheses.",
            "spheres too bright, lit from wrong sides"),
    MISTAKE("W-largest", surface_normal, by_its_largest, "point - c by its largest component",
            "then the largest component is 1. The length is 1 only at six points.",
            "faint edges across each sphere, as on a cube"),
    {0},
};
