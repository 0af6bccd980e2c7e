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

// In place of the dot product: components multiplied, and the first one taken.
static Quadratic first_components_only(Ray ray, double r)
{
    vec3 p = ray.origin, v = ray.direction;
    return (Quadratic){(v * v)[0], 2 * (p * v)[0], (p * p)[0] - r * r};
}

const Mistake object_mistakes[] = {
    MISTAKE("Q7", to_object_coordinates, centre_not_subtracted, "p as it came",
            "that is the eye as seen from the world's origin, and it is wanted as seen from the "
            "middle of the sphere.",
            "every sphere in the middle of the world"),
    MISTAKE("Q9", to_object_coordinates, centre_added, "p + c",
            "whoever goes to the sphere's centre sees the eye move the other way.",
            "every sphere mirrored to the other side of the world's origin"),
    MISTAKE("O-eye", to_object_coordinates, seen_from_the_eye, "c - p",
            "this is the centre as seen from the eye; what is wanted is the eye, as seen from the "
            "centre.",
            "nothing of what is ahead, but what is behind the eye"),
    MISTAKE("O-both", to_object_coordinates, direction_moved_too, "p - c, and v - c too",
            "a direction is a difference of two points. Seen from elsewhere it stays what it is.",
            "spheres bent and out of place, but for one in the middle of the world"),
    MISTAKE("O-v", to_object_coordinates, direction_moved_only, "p as it came, and v - c",
            "the ray begins elsewhere when it is seen from elsewhere; where it points to does not "
            "change.",
            "spheres bent and out of place, but for one in the middle of the world"),
    MISTAKE("O-unit", to_object_coordinates, direction_made_unit, "v / |v|",
            "it points the right way, but now t counts in lengths of 1, and whoever goes t times "
            "the v of the world does not arrive on the sphere.",
            "the right outlines at wrong depths"),
    MISTAKE("O-radius", to_object_coordinates, divided_by_the_radius, "(p - c) / r",
            "seen from the centre the eye is as far away as it is in the world. Only the origin "
            "moves, nothing is scaled.",
            "large spheres too large and small ones too small"),

    MISTAKE("Q1", object_quadratic, half_b, "b = p.v",
            "multiply (p + tv).(p + tv) out: p meets v in it more than once.",
            "holes, or a blank picture"),
    MISTAKE("Q2", object_quadratic, b_of_the_wrong_sign, "b = -2 p.v",
            "with this sign what lies ahead on the ray is found behind its origin.",
            "the sphere vanish, and one that is behind the eye appear"),
    MISTAKE("Q2-angle", object_quadratic, b_without_cosine, "b = 2 |p| |v|",
            "that is their dot product only where p and v point the same way. The angle between "
            "them counts, and an obtuse one makes b negative.",
            "a blank picture"),
    MISTAKE("Q3", object_quadratic, radius_not_squared, "c = p.p - r",
            "p.p is the square of a length and r is a length, so they cannot be compared. With a "
            "radius of 1 it does not show.",
            "spheres of the wrong size, but for those of radius 1"),
    MISTAKE("Q3-length", object_quadratic, lengths_not_squared, "c = |p| - r",
            "these are plain lengths, while t^2 and t stand beside squared ones.",
            "bloated spheres that fill the picture"),
    MISTAKE("Q4", object_quadratic, radius_added, "c = p.p + r^2",
            "c is what is left at t = 0, so for an eye on the surface it must be 0; this never is.",
            "a blank picture"),
    MISTAKE("Q4-sign", object_quadratic, c_of_the_wrong_sign, "c = r^2 - p.p",
            "moved to the other side the whole equation changes its sign, yet a and b have kept "
            "theirs.",
            "a picture filled by the sphere: every ray hits"),
    MISTAKE("Q-point", object_quadratic, radius_left_out, "c = p.p",
            "without its radius a sphere is only its centre, and hardly any ray meets that.",
            "a blank picture"),
    MISTAKE("Q-abs", object_quadratic, absolute_c, "c made positive",
            "for an eye inside the sphere c is negative, and that is what puts one root ahead of "
            "it and the other behind.",
            "a sphere that vanishes as soon as the eye is inside"),
    MISTAKE("Q5", object_quadratic, a_is_1, "a = 1",
            "that needs a v of length 1. The ray of a pixel ends on the image plane, so v is as "
            "long as the way there.",
            "distorted spheres, bloated where v is long"),
    MISTAKE("Q5-root", object_quadratic, a_is_a_length, "a = |v|",
            "the lengths in this equation are squared, that of v too. With a v of length 1 it does "
            "not show.",
            "distorted spheres, bloated where v is long"),
    MISTAKE("Q-p", object_quadratic, length_for_square_of_p, "c = |p| - r^2",
            "|p| is a length, r^2 the square of one, so they cannot be compared. p.p is |p|^2.",
            "bloated spheres that fill the picture"),
    MISTAKE("Q-lengths", object_quadratic, lengths_for_squares, "a = |v|, c = |p| - r^2",
            "the dot product of a vector with itself is the square of its length, and all lengths "
            "in this equation are squared.",
            "distorted spheres that fill the picture"),
    MISTAKE("Q-swap", object_quadratic, a_and_c_swapped, "a and c swapped",
            "a stands beside t^2, c stands alone: it is what is left of the equation at t = 0, "
            "where the ray begins.",
            "the right outlines, but what is far covers what is near"),
    MISTAKE("Q-dot", object_quadratic, first_components_only, "only the x of every product",
            "v * w multiplies component by component; a dot product is the sum of all three.",
            "a wall in place of the sphere: every ray hits"),
    {0},
};
