// mistakes-world.c - wrong answers in world coordinates: places where the centre is lost.
#include "tests/05-quadratic/mistakes.h"

// The slide's a, b, c for a ray seen from some point: q takes the place of p - C.
static Quadratic seen_from(vec3 q, Ray ray, double r)
{
    vec3 v = ray.direction;
    return (Quadratic){vec3_dot(v, v), 2 * vec3_dot(q, v), vec3_dot(q, q) - r * r};
}

static Quadratic right(Ray ray, Sphere s)
{
    return seen_from(ray.origin - s.center, ray, s.radius);
}

static Quadratic centre_left_out(Ray ray, Sphere s)
{
    return seen_from(ray.origin, ray, s.radius);
}

static Quadratic centre_added(Ray ray, Sphere s)
{
    return seen_from(ray.origin + s.center, ray, s.radius);
}

static Quadratic b_from_the_eye(Ray ray, Sphere s)
{
    return seen_from(s.center - ray.origin, ray, s.radius);
}

static Quadratic half_b(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){q.a, q.b / 2, q.c};
}

static Quadratic half_of_the_centre_in_b(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){q.a, q.b + vec3_dot(s.center, ray.direction), q.c};
}

static Quadratic centre_only_in_c(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){q.a, 2 * vec3_dot(ray.origin, ray.direction), q.c};
}

static Quadratic centre_added_in_b(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){q.a, 2 * vec3_dot(ray.origin + s.center, ray.direction), q.c};
}

static Quadratic radius_not_squared(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){q.a, q.b, q.c + s.radius * s.radius - s.radius};
}

static Quadratic radius_added(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){q.a, q.b, q.c + 2 * s.radius * s.radius};
}

static Quadratic radius_left_out(Ray ray, Sphere s)
{
    return seen_from(ray.origin - s.center, ray, 0);
}

static Quadratic a_is_1(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){1, q.b, q.c};
}

static Quadratic a_is_a_length(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){vec3_length(ray.direction), q.b, q.c};
}

static Quadratic lengths_for_squares(Ray ray, Sphere s)
{
    Quadratic q = a_is_a_length(ray, s);
    return (Quadratic){q.a, q.b, vec3_length(ray.origin - s.center) - s.radius * s.radius};
}

// |p - C|^2 = |p|^2 - |C|^2
static Quadratic squares_subtracted(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){q.a, q.b,
                       vec3_dot(ray.origin, ray.origin) - vec3_dot(s.center, s.center) -
                           s.radius * s.radius};
}

static Quadratic squares_added(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){q.a, q.b, q.c + 2 * vec3_dot(ray.origin, s.center)};
}

static Quadratic mixed_product_once(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){q.a, q.b, q.c + vec3_dot(ray.origin, s.center)};
}

static Quadratic mixed_product_added(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){q.a, q.b, q.c + 4 * vec3_dot(ray.origin, s.center)};
}

static Quadratic centre_squared_left_out(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){q.a, q.b, q.c - vec3_dot(s.center, s.center)};
}

static Quadratic centre_squared_subtracted(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){q.a, q.b, q.c - 2 * vec3_dot(s.center, s.center)};
}

static Quadratic direction_from_the_centre(Ray ray, Sphere s)
{
    ray.direction -= s.center;
    return right(ray, s);
}

const Mistake world_mistakes[] = {
    MISTAKE("Q7-world", world_quadratic, centre_left_out, "b = 2 p.v, c = p.p - r^2",
            "the centre is missing in both, so this is a sphere at the origin of the world.",
            "every sphere at the origin of the world"),
    MISTAKE("Q9-world", world_quadratic, centre_added, "b = 2 (p + C).v, c = |p + C|^2 - r^2",
            "the length of p + C is the distance from p to -C, and the sphere is not there.",
            "every sphere mirrored to the other side of the world's origin"),
    MISTAKE("Q2-world", world_quadratic, b_from_the_eye, "b = 2 (C - p).v",
            "with this sign, places ahead on the ray come out behind its origin. c is right, "
            "because squares ignore the sign; b is not.",
            "spheres vanish, and those behind the eye appear"),
    MISTAKE("Q1-world", world_quadratic, half_b, "b = p.v - C.v",
            "square p - C + tv: the product of p - C with v occurs twice.",
            "holes, or a blank picture"),
    MISTAKE("Q1-half", world_quadratic, half_of_the_centre_in_b, "b = 2 p.v - C.v",
            "only the eye's part is doubled. If eye and sphere move together nothing may change, "
            "but here b does.",
            "spheres of the wrong size in the wrong places, except one at the origin of the world"),
    MISTAKE("Q-b", world_quadratic, centre_only_in_c, "b = 2 p.v",
            "c knows the centre but b does not: they describe two different spheres.",
            "spheres of the wrong size in the wrong places, except one at the origin of the world"),
    MISTAKE("Q9-b", world_quadratic, centre_added_in_b, "b = 2 (p.v + C.v)",
            "c measures from the centre, but b from the opposite point, -C.",
            "spheres of the wrong size in the wrong places, except one at the origin of the world"),
    MISTAKE("Q3-world", world_quadratic, radius_not_squared, "c = |p - C|^2 - r",
            "one is a squared length, the other a length. If r is 1, you do not see it.",
            "spheres of the wrong size, except those of radius 1"),
    MISTAKE(
        "Q4-world", world_quadratic, radius_added, "c = |p - C|^2 + r^2",
        "at t = 0 only c is left, so for an eye on the surface it must be 0; this c is never 0.",
        "a blank picture"),
    MISTAKE("Q-point-world", world_quadratic, radius_left_out, "c = |p - C|^2",
            "without its radius a sphere is only its centre, and hardly any ray hits a point.",
            "a blank picture"),
    MISTAKE("Q5-world", world_quadratic, a_is_1, "a = 1",
            "this is true only if v has length 1. The v of a pixel's ray ends on the image plane, "
            "so it is longer.",
            "distorted spheres, bloated if v is long"),
    MISTAKE("Q5-root-world", world_quadratic, a_is_a_length, "a = |v|",
            "all lengths in this equation are squared, also that of v. If v has length 1, you do "
            "not see it.",
            "distorted spheres, bloated if v is long"),
    MISTAKE("Q-lengths-world", world_quadratic, lengths_for_squares, "a = |v|, c = |p - C| - r^2",
            "the dot product of a vector with itself is the square of its length, and all lengths "
            "in this equation are squared.",
            "distorted spheres that fill the picture"),
    MISTAKE("Q-squares", world_quadratic, squares_subtracted, "c = p.p - C.C - r^2",
            "p.p - C.C is 0 if eye and centre are equally far from the world's origin, however far "
            "they are from each other.",
            "spheres far too large, except one at the origin of the world"),
    MISTAKE("Q-sum", world_quadratic, squares_added, "c = p.p + C.C - r^2",
            "this is the squared distance only if eye and centre are at a right angle seen from "
            "the world's origin.",
            "spheres of the wrong size, except one at the origin of the world"),
    MISTAKE("Q-once", world_quadratic, mixed_product_once, "c = p.p - p.C + C.C - r^2",
            "multiply out (p - C).(p - C): p.C occurs twice.",
            "spheres of the wrong size, except one at the origin of the world"),
    MISTAKE("Q9-c", world_quadratic, mixed_product_added, "c = p.p + 2 p.C + C.C - r^2",
            "this measures the eye from -C, opposite to the centre.",
            "spheres of the wrong size, except one at the origin of the world"),
    MISTAKE("Q-cc", world_quadratic, centre_squared_left_out, "c = p.p - 2 p.C - r^2",
            "C.C is missing: for an eye at the world's origin nothing of the distance to the "
            "sphere is left.",
            "spheres that grow with their distance from the origin of the world"),
    MISTAKE(
        "Q-cc-sign", world_quadratic, centre_squared_subtracted, "c = p.p - 2 p.C - C.C - r^2",
        "for an eye at the world's origin the squared distance would be -C.C, which is negative.",
        "spheres that grow with their distance from the origin of the world"),
    MISTAKE("Q-v", world_quadratic, direction_from_the_centre, "v - C instead of v",
            "a direction is a difference of two points. Seen from the centre it is the same.",
            "spheres bent and out of place, except one at the origin of the world"),
    {0},
};
