// mistakes-sphere.c - wrong places where a line meets a sphere.
#include "tests/05-quadratic/mistakes.h"

static Roots sphere_at_the_origin(Ray ray, Sphere s)
{
    return quadratic_roots(object_quadratic(ray, s.radius));
}

static Roots direction_made_unit_first(Ray ray, Sphere s)
{
    ray.direction = vec3_unit(ray.direction);
    return slide_for_spheres(ray, s);
}

static Roots ahead_only(Ray ray, Sphere s)
{
    Roots roots = slide_for_spheres(ray, s);
    return roots.count == 2 && roots.t[1] <= 0 ? no_roots : roots;
}

static Roots outside_only(Ray ray, Sphere s)
{
    Roots roots = slide_for_spheres(ray, s);
    return roots.count == 2 && roots.t[0] < 0 && roots.t[1] > 0 ? (Roots){1, {roots.t[1]}} : roots;
}

static Roots tangent_is_a_miss(Ray ray, Sphere s)
{
    Roots roots = slide_for_spheres(ray, s);
    return roots.count == 2 && roots.t[0] == roots.t[1] ? no_roots : roots;
}

static Roots tangent_is_met_once(Ray ray, Sphere s)
{
    Roots roots = slide_for_spheres(ray, s);
    return roots.count == 2 && roots.t[0] == roots.t[1] ? (Roots){1, {roots.t[0]}} : roots;
}

static Roots always_met(Ray ray, Sphere s)
{
    Roots roots = slide_for_spheres(ray, s);
    double middle =
        -vec3_dot(ray.origin - s.center, ray.direction) / vec3_dot(ray.direction, ray.direction);
    return roots.count == 0 ? (Roots){2, {middle, middle}} : roots;
}

static Roots radius_doubled(Ray ray, Sphere s)
{
    s.radius *= 2;
    return slide_for_spheres(ray, s);
}

static Roots far_one_first(Ray ray, Sphere s)
{
    Roots roots = slide_for_spheres(ray, s);
    return roots.count == 2 ? (Roots){2, {roots.t[1], roots.t[0]}} : roots;
}

static Roots in_single_precision(Ray ray, Sphere s)
{
    Quadratic q = object_quadratic(to_object_coordinates(ray, s), s.radius);
    return slide((Quadratic){(float)q.a, (float)q.b, (float)q.c});
}

// By the closest approach, as the extra suggests: it is at foot, at the distance l from the centre.
static Roots by_closest_approach(Ray ray, Sphere s, double foot, double half_chord)
{
    vec3 closest = ray.origin + foot * ray.direction - s.center;
    if (!(vec3_length(closest) <= s.radius))
        return no_roots;
    return (Roots){2, {foot - half_chord, foot + half_chord}};
}

static double foot_of(Ray ray, Sphere s)
{
    return -vec3_dot(ray.origin - s.center, ray.direction) / vec3_dot(ray.direction, ray.direction);
}

static double half_chord_of(Ray ray, Sphere s)
{
    double l = vec3_length(ray.origin + foot_of(ray, s) * ray.direction - s.center);
    return sqrt((s.radius - l) * (s.radius + l));
}

static Roots chord_as_a_length(Ray ray, Sphere s)
{
    return by_closest_approach(ray, s, foot_of(ray, s), half_chord_of(ray, s));
}

static Roots chord_divided_by_a(Ray ray, Sphere s)
{
    return by_closest_approach(ray, s, foot_of(ray, s),
                               half_chord_of(ray, s) / vec3_dot(ray.direction, ray.direction));
}

static Roots foot_as_if_unit(Ray ray, Sphere s)
{
    double foot = -vec3_dot(ray.origin - s.center, ray.direction);
    double l = vec3_length(ray.origin + foot * ray.direction - s.center);
    return by_closest_approach(ray, s, foot,
                               sqrt((s.radius - l) * (s.radius + l)) / vec3_length(ray.direction));
}

static Roots chord_not_squared(Ray ray, Sphere s)
{
    double l = vec3_length(ray.origin + foot_of(ray, s) * ray.direction - s.center);
    return by_closest_approach(ray, s, foot_of(ray, s),
                               (s.radius - l) / vec3_length(ray.direction));
}

const Mistake sphere_mistakes[] = {
    MISTAKE("Q7-roots", sphere_roots, sphere_at_the_origin,
            "a, b, c of the ray in world coordinates",
            "without the step to object coordinates this is a sphere at the origin of the world.",
            "every sphere at the origin of the world"),
    MISTAKE("S-unit", sphere_roots, direction_made_unit_first, "v / |v|, and its roots",
            "these roots are lengths in the world, but the caller needs t in lengths of v.",
            "the right outlines at wrong depths"),
    MISTAKE(
        "S-ahead", sphere_roots, ahead_only, "nothing if both roots are behind",
        "this function returns the places of the whole line. hit_sphere decides which are ahead.",
        "no visible difference, until a caller needs the places behind"),
    MISTAKE("S-inside", sphere_roots, outside_only, "only the root ahead, from inside",
            "the line also meets the sphere behind the eye, and this function returns the places "
            "of the whole line.",
            "no visible difference, until a caller needs the places behind"),
    MISTAKE("R5-sphere", sphere_roots, tangent_is_a_miss, "a miss if the line just touches",
            "at l = r both places are equal, but the line does touch the sphere.",
            "hardly anything: single pixels missing at the edge"),
    MISTAKE("S-once", sphere_roots, tangent_is_met_once, "one root if the line just touches",
            "both places are equal, but they still count as two.",
            "hardly anything: single pixels missing at the edge"),
    MISTAKE(
        "S-always", sphere_roots, always_met, "t = -p.v / v.v if it misses",
        "this is where the line is closest to the sphere, and it does not meet the sphere there.",
        "a picture filled by the sphere: every ray hits"),
    MISTAKE("S-double", sphere_roots, radius_doubled, "2r instead of r",
            "r is the distance from the centre to the surface, not from side to side.",
            "spheres of twice the size"),
    MISTAKE(
        "S-down", sphere_roots, far_one_first, "the far place first",
        "the eye sees the place that comes first along the ray, and hit_sphere expects it in t[0].",
        "the inside of every sphere"),
    MISTAKE("S-float", sphere_roots, in_single_precision, "a, b, c as float",
            "a float has 7 digits, and too few of them are left in p.p - r^2 for a sphere some "
            "radii away.",
            "rough, speckled spheres in the distance"),
    MISTAKE("S-chord", sphere_roots, chord_as_a_length, "t = -p.v / v.v +- sqrt(r^2 - l^2)",
            "the first part is in lengths of v, but half the chord is a length in the world. "
            "Convert one before you add them.",
            "the right outlines, but spheres too flat or too deep"),
    MISTAKE("S-chord-a", sphere_roots, chord_divided_by_a, "t = (-p.v +- sqrt(r^2 - l^2)) / v.v",
            "v.v is the squared length of v. Half the chord is a plain length: divide it by |v|.",
            "the right outlines, but spheres too flat or too deep"),
    MISTAKE(
        "S-foot", sphere_roots, foot_as_if_unit, "closest approach at t = -p.v",
        "this is true only if v has length 1. With a longer one the point is beyond the sphere.",
        "a blank picture, or distorted spheres"),
    MISTAKE("S-square", sphere_roots, chord_not_squared, "half chord = r - l",
            "the radius, l and half the chord are the sides of a right-angled triangle, so the "
            "squares add up.",
            "the right outlines, but pointed where spheres should be round"),
    {0},
};
