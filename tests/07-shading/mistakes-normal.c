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
            "that points away from the origin of the world. A sphere's normal points away from its "
            "own centre.",
            "shading that is right only for a sphere round the origin"),
    MISTAKE("W2-r", surface_normal, point_through_radius, "point / r",
            "a radius leads from the centre to the point, and the centre is left out.",
            "shading that is right only for a sphere round the origin"),
    MISTAKE("W2-point", surface_normal, point_as_it_is, "the point itself",
            "that is the way from the origin of the world, as long as it happens to be.",
            "glaring spheres, lit from odd sides"),
    MISTAKE("W3", surface_normal, inward, "(c - point) / |c - point|",
            "that points into the sphere, to its centre.",
            "dark where it should be light, and light where it should be dark"),
    MISTAKE("W3-length", surface_normal, inward_not_unit, "c - point",
            "that points into the sphere, and is as long as its radius.",
            "dark where it should be light, and light where it should be dark"),
    MISTAKE("W-length", surface_normal, not_unit, "point - c",
            "it is as long as the radius. A normal is unit, or cosines come out too large.",
            "large spheres burnt out, small ones nearly black"),
    MISTAKE("W-squared", surface_normal, through_radius_squared, "(point - c) / r^2",
            "point - c is as long as r, so to divide by r once makes it unit.",
            "small spheres burnt out, large ones nearly black"),
    MISTAKE("W-times", surface_normal, times_radius, "(point - c) r",
            "point - c is already as long as r: divide by it.",
            "large spheres burnt out, small ones nearly black"),
    MISTAKE("W-plus", surface_normal, centre_added, "(point + c) / |point + c|",
            "the way from the centre to the point is the point less the centre.",
            "spheres lit from odd sides, worse the farther they are from the origin"),
    MISTAKE("W-scalar", surface_normal, radius_subtracted, "point - c - r",
            "a vector less a number takes the number from each component. To make it shorter, "
            "divide.",
            "spheres that are dark from most sides, and glare"),
    MISTAKE("W-early", surface_normal, made_unit_too_early, "point / |point| - c / |c|",
            "lengths are lost before the difference is taken. First the difference, then unit.",
            "nearly black spheres; nothing at all for one round the origin"),
    MISTAKE("W-other", surface_normal, through_length_of_point, "(point - c) / |point|",
            "it must be divided by its own length, which is |point - c|.",
            "spheres the darker, the farther they are from the origin"),
    MISTAKE("W-brackets", surface_normal, precedence_of_division, "point - c / r",
            "division comes first, so only c is divided. The difference needs brackets.",
            "glaring spheres, lit from odd sides"),
    MISTAKE("W-largest", surface_normal, by_its_largest, "point - c by its largest component",
            "the largest component is 1 then. The length is not, but for six points.",
            "faint edges across each sphere, as on a cube"),
    {0},
};
