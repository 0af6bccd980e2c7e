// mistakes-hit.c - wrong hits: the wrong place, or a place that is not ahead.
#include "tests/05-quadratic/mistakes.h"

static double first_root_above(Roots roots, double least)
{
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > least)
            return roots.t[i];
    return NO_HIT;
}

static double far_root(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    return roots.count > 0 && roots.t[1] > 0 ? roots.t[1] : NO_HIT;
}

static double first_root_even_behind(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    return roots.count > 0 ? roots.t[0] : NO_HIT;
}

static double second_root_even_behind(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    if (roots.count == 0)
        return NO_HIT;
    return roots.t[0] > 0 ? roots.t[0] : roots.t[1];
}

static double missed_from_inside(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    return roots.count > 0 && roots.t[0] > 0 ? roots.t[0] : NO_HIT;
}

static double epsilon_of_a_tenth(Ray ray, Sphere s)
{
    return first_root_above(sphere_roots(ray, s), 0.1);
}

static double epsilon_of_a_thousandth(Ray ray, Sphere s)
{
    return first_root_above(sphere_roots(ray, s), 0.001);
}

static double from_the_image_plane(Ray ray, Sphere s)
{
    return first_root_above(sphere_roots(ray, s), 1);
}

static double zero_is_a_hit(Ray ray, Sphere s)
{
    return first_root_above(sphere_roots(ray, s), -1e-300);
}

static double tangent_missed(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    bool touches = roots.count == 2 && roots.t[0] == roots.t[1];
    return touches ? NO_HIT : first_root_above(roots, 0);
}

static double minus_1_for_no_hit(Ray ray, Sphere s)
{
    double t = hit_sphere(ray, s);
    return t < NO_HIT ? t : -1;
}

static double zero_for_no_hit(Ray ray, Sphere s)
{
    double t = hit_sphere(ray, s);
    return t < NO_HIT ? t : 0;
}

static double way_for_t(Ray ray, Sphere s)
{
    return hit_sphere(ray, s) * vec3_length(ray.direction);
}

static double both_ways(Ray ray, Sphere s)
{
    return fabs(first_root_even_behind(ray, s));
}

static double middle_of_the_chord(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    double middle = (roots.t[0] + roots.t[1]) / 2;
    return roots.count > 0 && middle > 0 ? middle : NO_HIT;
}

static double centre_forgotten(Ray ray, Sphere s)
{
    s.center = vec3_of(0, 0, 0);
    return hit_sphere(ray, s);
}

static double count_not_asked(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    if (roots.t[0] > 0)
        return roots.t[0];
    return roots.t[1] > 0 ? roots.t[1] : roots.t[0];
}

static double first_whatever_count(Ray ray, Sphere s)
{
    return sphere_roots(ray, s).t[0];
}

static double surface_is_left_behind(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    return roots.count > 0 && roots.t[0] == 0 ? NO_HIT : first_root_above(roots, 0);
}

// All in one function, with one slip.
static Quadratic equation(Ray ray, Sphere s)
{
    return object_quadratic(to_object_coordinates(ray, s), s.radius);
}

static double half_b_in_place(Ray ray, Sphere s)
{
    Quadratic q = equation(ray, s);
    return first_root_above(slide((Quadratic){q.a, q.b / 2, q.c}), 0);
}

static double a_is_1_in_place(Ray ray, Sphere s)
{
    Quadratic q = equation(ray, s);
    return first_root_above(slide((Quadratic){1, q.b, q.c}), 0);
}

static double halved_then_times_a_in_place(Ray ray, Sphere s)
{
    Quadratic q = equation(ray, s);
    return first_root_above(slide(q), 0) * q.a * q.a;
}

const Mistake hit_mistakes[] = {
    MISTAKE("R6", hit_sphere, far_root, "the far root",
            "the ray arrives at the near place first, and the sphere hides the far one.",
            "the inside of every sphere"),
    MISTAKE("R7", hit_sphere, first_root_even_behind, "t[0], even if it is not above 0",
            "places with t < 0 are behind the eye, and it cannot see them.",
            "ghosts of objects behind the eye"),
    MISTAKE("R7-far", hit_sphere, second_root_even_behind, "t[0] if it is above 0, else t[1]",
            "t[1] may also be behind the eye, if the whole sphere is behind it.",
            "ghosts of objects behind the eye"),
    MISTAKE("R8", hit_sphere, missed_from_inside, "a miss if t[0] is not above 0",
            "from inside the sphere only the entry is behind the eye. The place where the ray "
            "leaves is ahead.",
            "a sphere that vanishes as soon as the eye is inside"),
    MISTAKE("R10", hit_sphere, epsilon_of_a_tenth, "only t > 0.1",
            "t is not a distance: it counts in lengths of v. A tenth of v can be a long way, and "
            "every nearer hit is lost.",
            "holes in objects close to the eye"),
    MISTAKE("R10-small", hit_sphere, epsilon_of_a_thousandth, "only t > 0.001",
            "rays that start on a surface need such a limit; these start at the eye, and it sees "
            "objects close to it.",
            "holes in objects very close to the eye"),
    MISTAKE(
        "D1", hit_sphere, from_the_image_plane, "only t > 1",
        "t = 1 is on the image plane, but the eye also sees objects between itself and the plane.",
        "near spheres vanish, or show their inside"),
    MISTAKE("T-zero", hit_sphere, zero_is_a_hit, "t >= 0",
            "t = 0 is the eye itself, and a visible place is ahead of it.",
            "the whole picture covered by a sphere that the eye just touches"),
    MISTAKE("R5-hit", hit_sphere, tangent_missed, "a miss if both roots are equal",
            "such a ray just touches the sphere, and that is a hit.",
            "hardly anything: single pixels missing at the edge"),
    MISTAKE("T-minus1", hit_sphere, minus_1_for_no_hit, "-1 instead of NO_HIT",
            "a search for the smallest t finds -1 nearer than every sphere. NO_HIT is farther than "
            "all of them.",
            "a blank picture, or only the sphere that is last in the scene"),
    MISTAKE("T-none0", hit_sphere, zero_for_no_hit, "0 instead of NO_HIT",
            "a search for the smallest t finds 0 nearer than every sphere. NO_HIT is farther than "
            "all of them.",
            "a blank picture, or only the sphere that is last in the scene"),
    MISTAKE("T-way", hit_sphere, way_for_t, "t |v|",
            "this is the distance to the place in the world. t counts in lengths of v, so that p + "
            "tv is the place.",
            "the right outlines at wrong depths"),
    MISTAKE("T-abs", hit_sphere, both_ways, "|t|",
            "a negative t is behind the eye, and a positive sign does not bring it to the front.",
            "objects behind the eye appear ahead of it"),
    MISTAKE("T-middle", hit_sphere, middle_of_the_chord, "-b / (2a)",
            "this is where the ray is closest to the centre, deep inside the sphere.",
            "the right outlines, filled with flat discs"),
    MISTAKE(
        "Q7-hit", hit_sphere, centre_forgotten, "the ray in world coordinates, without the centre",
        "this is a sphere at the origin of the world.", "every sphere at the origin of the world"),
    MISTAKE("T-count", hit_sphere, count_not_asked, "t[0] and t[1], whatever count says",
            "if count is 0, the numbers in them mean nothing.",
            "a picture filled by the sphere: every ray hits"),
    MISTAKE("T-first", hit_sphere, first_whatever_count, "t[0], whatever count says",
            "if count is 0, the number in it means nothing, and if t[0] is behind the eye, t[1] "
            "may be ahead.",
            "a picture filled by the sphere: every ray hits"),
    MISTAKE("T-surface", hit_sphere, surface_is_left_behind, "a miss if t[0] is 0",
            "the ray starts on the surface there, but it may run through the sphere and hit the "
            "other side.",
            "a sphere that vanishes when the eye touches it"),
    MISTAKE("Q1-hit", hit_sphere, half_b_in_place, "b = p.v, with D = b^2 - 4ac",
            "this D needs the whole b, and p.v is only half of it.", "holes, or a blank picture"),
    MISTAKE("Q5-hit", hit_sphere, a_is_1_in_place, "a = 1",
            "this is true only if v has length 1. The v of a pixel's ray ends on the image plane, "
            "so it is longer.",
            "distorted spheres, bloated if v is long"),
    MISTAKE("R1-hit", hit_sphere, halved_then_times_a_in_place, "(-b - sqrt(D)) / 2 * a",
            "C evaluates from left to right: it divides by 2, then multiplies by a. If v has "
            "length 1, so a = 1, you do not see it.",
            "the right outlines at wrong depths"),
    {0},
};
