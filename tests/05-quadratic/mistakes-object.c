// mistakes-object.c - wrong answers in object coordinates: the ray, and a, b, c.
#include "tests/05-quadratic/mistakes.h"

// ---- to_object_coordinates ----------------------------------------------------------------------

static Ray centre_not_subtracted(Ray ray, Sphere s)
{
    (void)s;
    return ray;
}

static Ray centre_added(Ray ray, Sphere s)
{
    return (Ray){ray.origin + s.center, ray.direction};
}

static Ray seen_from_the_eye(Ray ray, Sphere s)
{
    return (Ray){s.center - ray.origin, ray.direction};
}

static Ray direction_moved_too(Ray ray, Sphere s)
{
    return (Ray){ray.origin - s.center, ray.direction - s.center};
}

static Ray direction_moved_only(Ray ray, Sphere s)
{
    return (Ray){ray.origin, ray.direction - s.center};
}

static Ray direction_made_unit(Ray ray, Sphere s)
{
    return (Ray){ray.origin - s.center, vec3_unit(ray.direction)};
}

static Ray divided_by_the_radius(Ray ray, Sphere s)
{
    return (Ray){(ray.origin - s.center) / s.radius, ray.direction};
}

// ---- object_quadratic ---------------------------------------------------------------------------

static Quadratic half_b(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){q.a, q.b / 2, q.c};
}

static Quadratic b_of_the_wrong_sign(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){q.a, -q.b, q.c};
}

static Quadratic b_without_cosine(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){q.a, 2 * vec3_length(ray.origin) * vec3_length(ray.direction), q.c};
}

static Quadratic radius_not_squared(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){q.a, q.b, vec3_dot(ray.origin, ray.origin) - r};
}

static Quadratic lengths_not_squared(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){q.a, q.b, vec3_length(ray.origin) - r};
}

static Quadratic radius_added(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){q.a, q.b, vec3_dot(ray.origin, ray.origin) + r * r};
}

static Quadratic c_of_the_wrong_sign(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){q.a, q.b, -q.c};
}

static Quadratic radius_left_out(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){q.a, q.b, vec3_dot(ray.origin, ray.origin)};
}

static Quadratic absolute_c(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){q.a, q.b, fabs(q.c)};
}

static Quadratic a_is_1(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){1, q.b, q.c};
}

static Quadratic a_is_a_length(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){vec3_length(ray.direction), q.b, q.c};
}

static Quadratic length_for_square_of_p(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){q.a, q.b, vec3_length(ray.origin) - r * r};
}

static Quadratic lengths_for_squares(Ray ray, double r)
{
    Quadratic q = length_for_square_of_p(ray, r);
    return (Quadratic){vec3_length(ray.direction), q.b, q.c};
}

static Quadratic a_and_c_swapped(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){q.c, q.b, q.a};
}

// Instead of the dot product: components multiplied, and the first one taken.
static Quadratic first_components_only(Ray ray, double r)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){(v * v)[0], 2 * (p * v)[0], (p * p)[0] - r * r};
}

const Mistake object_mistakes[] = {
    MISTAKE("Q7", to_object_coordinates, centre_not_subtracted, "p unchanged",
            "this is the eye seen from the world's origin, but it must be seen from the centre of "
            "the sphere.",
            "every sphere at the origin of the world"),
    MISTAKE("Q9", to_object_coordinates, centre_added, "p + c",
            "seen from the centre, the eye moves in the opposite direction: subtract c.",
            "every sphere mirrored to the other side of the world's origin"),
    MISTAKE(
        "O-eye", to_object_coordinates, seen_from_the_eye, "c - p",
        "this is the centre seen from the eye; the exercise asks for the eye seen from the centre.",
        "nothing from in front of the eye, but the scene behind it"),
    MISTAKE("O-both", to_object_coordinates, direction_moved_too, "p - c, and v - c as well",
            "a direction is a difference of two points. Seen from any other point it is the same.",
            "spheres bent and out of place, except one at the origin of the world"),
    MISTAKE("O-v", to_object_coordinates, direction_moved_only, "p unchanged, and v - c",
            "seen from another point the ray has another origin, but the same direction.",
            "spheres bent and out of place, except one at the origin of the world"),
    MISTAKE("O-unit", to_object_coordinates, direction_made_unit, "v / |v|",
            "it points in the right direction, but now t counts in lengths of 1: with the world's "
            "v, that t does not reach the sphere.",
            "the right outlines at wrong depths"),
    MISTAKE("O-radius", to_object_coordinates, divided_by_the_radius, "(p - c) / r",
            "seen from the centre the eye is as far away as in the world. Only the origin moves; "
            "nothing is scaled.",
            "large spheres too large and small ones too small"),

    MISTAKE("Q1", object_quadratic, half_b, "b = p.v",
            "multiply out (p + tv).(p + tv): p.v occurs twice.", "holes, or a blank picture"),
    MISTAKE("Q2", object_quadratic, b_of_the_wrong_sign, "b = -2 p.v",
            "with this sign, places ahead on the ray come out behind its origin.",
            "spheres vanish, and those behind the eye appear"),
    MISTAKE("Q2-angle", object_quadratic, b_without_cosine, "b = 2 |p| |v|",
            "this is their dot product only if p and v have the same direction. The angle between "
            "them counts, and an obtuse one makes b negative.",
            "a blank picture"),
    MISTAKE("Q3", object_quadratic, radius_not_squared, "c = p.p - r",
            "p.p is a squared length and r is a length: square r. If r is 1, you do not see it.",
            "spheres of the wrong size, except those of radius 1"),
    MISTAKE("Q3-length", object_quadratic, lengths_not_squared, "c = |p| - r",
            "these are plain lengths, but the terms with t^2 and t are squared lengths.",
            "bloated spheres that fill the picture"),
    MISTAKE(
        "Q4", object_quadratic, radius_added, "c = p.p + r^2",
        "at t = 0 only c is left, so for an eye on the surface it must be 0; this c is never 0.",
        "a blank picture"),
    MISTAKE("Q4-sign", object_quadratic, c_of_the_wrong_sign, "c = r^2 - p.p",
            "multiplying the equation by -1 changes every sign, but a and b kept theirs.",
            "a picture filled by the sphere: every ray hits"),
    MISTAKE("Q-point", object_quadratic, radius_left_out, "c = p.p",
            "without its radius a sphere is only its centre, and hardly any ray hits a point.",
            "a blank picture"),
    MISTAKE("Q-abs", object_quadratic, absolute_c, "c made positive",
            "for an eye inside the sphere c is negative, and that puts one root ahead of it and "
            "the other behind.",
            "a sphere that vanishes as soon as the eye is inside"),
    MISTAKE("Q5", object_quadratic, a_is_1, "a = 1",
            "this is true only if v has length 1. The v of a pixel's ray ends on the image plane, "
            "so it is longer.",
            "distorted spheres, bloated if v is long"),
    MISTAKE("Q5-root", object_quadratic, a_is_a_length, "a = |v|",
            "all lengths in this equation are squared, also that of v. If v has length 1, you do "
            "not see it.",
            "distorted spheres, bloated if v is long"),
    MISTAKE("Q-p", object_quadratic, length_for_square_of_p, "c = |p| - r^2",
            "|p| is a length and r^2 a squared length. Use p.p, which is |p|^2.",
            "bloated spheres that fill the picture"),
    MISTAKE("Q-lengths", object_quadratic, lengths_for_squares, "a = |v|, c = |p| - r^2",
            "the dot product of a vector with itself is the square of its length, and all lengths "
            "in this equation are squared.",
            "distorted spheres that fill the picture"),
    MISTAKE("Q-swap", object_quadratic, a_and_c_swapped, "a and c swapped",
            "a multiplies t^2; c alone is left of the equation at t = 0, where the ray starts.",
            "the right outlines, but far objects cover near ones"),
    MISTAKE("Q-dot", object_quadratic, first_components_only, "only the x of every product",
            "v * w multiplies component by component; a dot product is the sum of all three.",
            "a wall instead of the sphere: every ray hits"),
    {0},
};
