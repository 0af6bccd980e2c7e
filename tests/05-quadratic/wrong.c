// wrong.c - wrong answers to exercise 05.
#include "exercises/05-quadratic.h"

#include "tests/judge/known.h"

// ---- wrong answers in object coordinates: the ray, and a, b, c ----------------------------------

static const Roots no_roots = {0};

// The usual way to write it, with one slip. So it is right if a = 0.
static Roots line_root(Quadratic q)
{
    return q.b == 0 ? no_roots : (Roots){1, {-q.c / q.b}};
}

static Roots in_order(double t, double u)
{
    return t <= u ? (Roots){2, {t, u}} : (Roots){2, {u, t}};
}

static double discriminant(Quadratic q)
{
    return q.b * q.b - 4 * q.a * q.c;
}

// The formula of the slide: right, except for the digits that it loses.
static Roots slide(Quadratic q)
{
    double d = discriminant(q);
    if (q.a == 0)
        return line_root(q);
    if (d < 0)
        return no_roots;
    return in_order((-q.b - sqrt(d)) / (2 * q.a), (-q.b + sqrt(d)) / (2 * q.a));
}

static Roots slide_for_spheres(Ray ray, Sphere s)
{
    return slide(object_quadratic(to_object_coordinates(ray, s), s.radius));
}

// ---- object_quadratic ---------------------------------------------------------------------------

static Quadratic length_for_square_of_p(Ray ray, double r)
{
    Quadratic q = object_quadratic(ray, r);
    return (Quadratic){q.a, q.b, vec3_length(ray.origin) - r * r};
}

WRONG_LINE(to_object_coordinates, "Q7", "p unchanged",
           "this is the eye seen from the world's origin, but it must be seen from the centre of "
           "the sphere.",
           "every sphere at the origin of the world", return ray)
WRONG_LINE(to_object_coordinates, "Q9", "p + c",
           "seen from the centre, the eye moves in the opposite direction: subtract c.",
           "every sphere mirrored to the other side of the world's origin",
           return (Ray){ray.origin + sphere.center, ray.direction})
WRONG_LINE(
    to_object_coordinates, "O-eye", "c - p",
    "this is the centre seen from the eye; the exercise asks for the eye seen from the centre.",
    "nothing from in front of the eye, but the scene behind it",
    return (Ray){sphere.center - ray.origin, ray.direction})
WRONG_LINE(to_object_coordinates, "O-both", "p - c, and v - c as well",
           "a direction is a difference of two points. Seen from any other point it is the same.",
           "spheres bent and out of place, except one at the origin of the world",
           return (Ray){ray.origin - sphere.center, ray.direction - sphere.center})
WRONG_LINE(to_object_coordinates, "O-v", "p unchanged, and v - c",
           "seen from another point the ray has another origin, but the same direction.",
           "spheres bent and out of place, except one at the origin of the world",
           return (Ray){ray.origin, ray.direction - sphere.center})
WRONG_LINE(to_object_coordinates, "O-unit", "v / |v|",
           "it points in the right direction, but now t counts in lengths of 1: with the world's "
           "v, that t does not reach the sphere.",
           "the right outlines at wrong depths",
           return (Ray){ray.origin - sphere.center, vec3_unit(ray.direction)})
WRONG_LINE(to_object_coordinates, "O-radius", "(p - c) / r",
           "seen from the centre the eye is as far away as in the world. Only the origin moves; "
           "nothing is scaled.",
           "large spheres too large and small ones too small",
           return (Ray){(ray.origin - sphere.center) / sphere.radius, ray.direction})

// From the right coefficients.
#define OF_OBJECT(id, formula, why, picture, ...)                                                  \
    WRONG(object_quadratic, id, formula, why, picture)                                             \
    {                                                                                              \
        Quadratic q = object_quadratic(object_ray, radius);                                        \
        __VA_ARGS__;                                                                               \
    }

OF_OBJECT("Q1", "b = p.v", "multiply out (p + tv).(p + tv): p.v occurs twice.",
          "holes, or a blank picture", return (Quadratic){q.a, q.b / 2, q.c})
OF_OBJECT("Q2", "b = -2 p.v", "with this sign, places ahead on the ray come out behind its origin.",
          "spheres vanish, and those behind the eye appear", return (Quadratic){q.a, -q.b, q.c})
OF_OBJECT(
    "Q2-angle", "b = 2 |p| |v|",
    "this is their dot product only if p and v have the same direction. The angle between them "
    "counts, and an obtuse one makes b negative.",
    "a blank picture",
    return (Quadratic){q.a, 2 * vec3_length(object_ray.origin) * vec3_length(object_ray.direction),
                       q.c})
OF_OBJECT("Q3", "c = p.p - r",
          "p.p is a squared length and r is a length: square r. If r is 1, you do not see it.",
          "spheres of the wrong size, except those of radius 1",
          return (Quadratic){q.a, q.b, vec3_dot(object_ray.origin, object_ray.origin) - radius})
OF_OBJECT("Q3-length", "c = |p| - r",
          "these are plain lengths, but the terms with t^2 and t are squared lengths.",
          "bloated spheres that fill the picture",
          return (Quadratic){q.a, q.b, vec3_length(object_ray.origin) - radius})

WRONG(object_quadratic, "Q4", "c = p.p + r^2",
      "at t = 0 only c is left, so for an eye on the surface it must be 0; this c is never 0.",
      "a blank picture")
{
    Quadratic q = object_quadratic(object_ray, radius);
    return (Quadratic){q.a, q.b, vec3_dot(object_ray.origin, object_ray.origin) + radius * radius};
}

OF_OBJECT("Q4-sign", "c = r^2 - p.p",
          "multiplying the equation by -1 changes every sign, but a and b kept theirs.",
          "a picture filled by the sphere: every ray hits", return (Quadratic){q.a, q.b, -q.c})
OF_OBJECT("Q-point", "c = p.p",
          "without its radius a sphere is only its centre, and hardly any ray hits a point.",
          "a blank picture",
          return (Quadratic){q.a, q.b, vec3_dot(object_ray.origin, object_ray.origin)})
OF_OBJECT("Q-abs", "c made positive",
          "for an eye inside the sphere c is negative, and that puts one root ahead of it and the "
          "other behind.",
          "a sphere that vanishes as soon as the eye is inside",
          return (Quadratic){q.a, q.b, fabs(q.c)})
OF_OBJECT(
    "Q5", "a = 1",
    "this is true only if v has length 1. The v of a pixel's ray ends on the image plane, so it "
    "is longer.",
    "distorted spheres, bloated if v is long", return (Quadratic){1, q.b, q.c})
OF_OBJECT(
    "Q5-root", "a = |v|",
    "all lengths in this equation are squared, also that of v. If v has length 1, you do not see "
    "it.",
    "distorted spheres, bloated if v is long",
    return (Quadratic){vec3_length(object_ray.direction), q.b, q.c})

WRONG_BY(length_for_square_of_p, object_quadratic, "Q-p", "c = |p| - r^2",
         "|p| is a length and r^2 a squared length. Use p.p, which is |p|^2.",
         "bloated spheres that fill the picture")

WRONG(object_quadratic, "Q-lengths", "a = |v|, c = |p| - r^2",
      "the dot product of a vector with itself is the square of its length, and all lengths in "
      "this equation are squared.",
      "distorted spheres that fill the picture")
{
    Quadratic q = length_for_square_of_p(object_ray, radius);
    return (Quadratic){vec3_length(object_ray.direction), q.b, q.c};
}

OF_OBJECT("Q-swap", "a and c swapped",
          "a multiplies t^2; c alone is left of the equation at t = 0, where the ray starts.",
          "the right outlines, but far objects cover near ones", return (Quadratic){q.c, q.b, q.a})

// Instead of the dot product: components multiplied, and the first one taken.
WRONG(object_quadratic, "Q-dot", "only the x of every product",
      "v * w multiplies component by component; a dot product is the sum of all three.",
      "a wall instead of the sphere: every ray hits")
{
    vec3 p = object_ray.origin, v = object_ray.direction;
    return (Quadratic){(v * v)[0], 2 * (p * v)[0], (p * p)[0] - radius * radius};
}

// ---- wrong answers in world coordinates: places where the centre is lost ------------------------

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

static Quadratic a_is_a_length(Ray ray, Sphere s)
{
    Quadratic q = right(ray, s);
    return (Quadratic){vec3_length(ray.direction), q.b, q.c};
}

WRONG_LINE(world_quadratic, "Q7-world", "b = 2 p.v, c = p.p - r^2",
           "the centre is missing in both, so this is a sphere at the origin of the world.",
           "every sphere at the origin of the world",
           return seen_from(ray.origin, ray, sphere.radius))
WRONG_LINE(world_quadratic, "Q9-world", "b = 2 (p + C).v, c = |p + C|^2 - r^2",
           "the length of p + C is the distance from p to -C, and the sphere is not there.",
           "every sphere mirrored to the other side of the world's origin",
           return seen_from(ray.origin + sphere.center, ray, sphere.radius))
WRONG_LINE(world_quadratic, "Q2-world", "b = 2 (C - p).v",
           "with this sign, places ahead on the ray come out behind its origin. c is right, "
           "because squares ignore the sign; b is not.",
           "spheres vanish, and those behind the eye appear",
           return seen_from(sphere.center - ray.origin, ray, sphere.radius))

// From the right coefficients.
#define OF_WORLD(id, formula, why, picture, ...)                                                   \
    WRONG(world_quadratic, id, formula, why, picture)                                              \
    {                                                                                              \
        Quadratic q = right(ray, sphere);                                                          \
        __VA_ARGS__;                                                                               \
    }

OF_WORLD("Q1-world", "b = p.v - C.v",
         "square p - C + tv: the product of p - C with v occurs twice.",
         "holes, or a blank picture", return (Quadratic){q.a, q.b / 2, q.c})
OF_WORLD("Q1-half", "b = 2 p.v - C.v",
         "only the eye's part is doubled. If eye and sphere move together nothing may change, but "
         "here b does.",
         "spheres of the wrong size in the wrong places, except one at the origin of the world",
         return (Quadratic){q.a, q.b + vec3_dot(sphere.center, ray.direction), q.c})
OF_WORLD("Q-b", "b = 2 p.v",
         "c knows the centre but b does not: they describe two different spheres.",
         "spheres of the wrong size in the wrong places, except one at the origin of the world",
         return (Quadratic){q.a, 2 * vec3_dot(ray.origin, ray.direction), q.c})
OF_WORLD("Q9-b", "b = 2 (p.v + C.v)",
         "c measures from the centre, but b from the opposite point, -C.",
         "spheres of the wrong size in the wrong places, except one at the origin of the world",
         return (Quadratic){q.a, 2 * vec3_dot(ray.origin + sphere.center, ray.direction), q.c})

WRONG(world_quadratic, "Q3-world", "c = |p - C|^2 - r",
      "one is a squared length, the other a length. If r is 1, you do not see it.",
      "spheres of the wrong size, except those of radius 1")
{
    Quadratic q = right(ray, sphere);
    return (Quadratic){q.a, q.b, q.c + sphere.radius * sphere.radius - sphere.radius};
}

WRONG(world_quadratic, "Q4-world", "c = |p - C|^2 + r^2",
      "at t = 0 only c is left, so for an eye on the surface it must be 0; this c is never 0.",
      "a blank picture")
{
    Quadratic q = right(ray, sphere);
    return (Quadratic){q.a, q.b, q.c + 2 * sphere.radius * sphere.radius};
}

WRONG_LINE(world_quadratic, "Q-point-world", "c = |p - C|^2",
           "without its radius a sphere is only its centre, and hardly any ray hits a point.",
           "a blank picture", return seen_from(ray.origin - sphere.center, ray, 0))

OF_WORLD(
    "Q5-world", "a = 1",
    "this is true only if v has length 1. The v of a pixel's ray ends on the image plane, so it "
    "is longer.",
    "distorted spheres, bloated if v is long", return (Quadratic){1, q.b, q.c})

WRONG_BY(a_is_a_length, world_quadratic, "Q5-root-world", "a = |v|",
         "all lengths in this equation are squared, also that of v. If v has length 1, you do not "
         "see it.",
         "distorted spheres, bloated if v is long")

WRONG(world_quadratic, "Q-lengths-world", "a = |v|, c = |p - C| - r^2",
      "the dot product of a vector with itself is the square of its length, and all lengths in "
      "this equation are squared.",
      "distorted spheres that fill the picture")
{
    Quadratic q = a_is_a_length(ray, sphere);
    return (Quadratic){q.a, q.b,
                       vec3_length(ray.origin - sphere.center) - sphere.radius * sphere.radius};
}

// |p - C|^2 = |p|^2 - |C|^2
WRONG(world_quadratic, "Q-squares", "c = p.p - C.C - r^2",
      "p.p - C.C is 0 if eye and centre are equally far from the world's origin, however far they "
      "are from each other.",
      "spheres far too large, except one at the origin of the world")
{
    Quadratic q = right(ray, sphere);
    return (Quadratic){q.a, q.b,
                       vec3_dot(ray.origin, ray.origin) - vec3_dot(sphere.center, sphere.center) -
                           sphere.radius * sphere.radius};
}

OF_WORLD("Q-sum", "c = p.p + C.C - r^2",
         "this is the squared distance only if eye and centre are at a right angle seen from the "
         "world's origin.",
         "spheres of the wrong size, except one at the origin of the world",
         return (Quadratic){q.a, q.b, q.c + 2 * vec3_dot(ray.origin, sphere.center)})
OF_WORLD("Q-once", "c = p.p - p.C + C.C - r^2", "multiply out (p - C).(p - C): p.C occurs twice.",
         "spheres of the wrong size, except one at the origin of the world",
         return (Quadratic){q.a, q.b, q.c + vec3_dot(ray.origin, sphere.center)})
OF_WORLD("Q9-c", "c = p.p + 2 p.C + C.C - r^2",
         "this measures the eye from -C, opposite to the centre.",
         "spheres of the wrong size, except one at the origin of the world",
         return (Quadratic){q.a, q.b, q.c + 4 * vec3_dot(ray.origin, sphere.center)})
OF_WORLD(
    "Q-cc", "c = p.p - 2 p.C - r^2",
    "C.C is missing: for an eye at the world's origin nothing of the distance to the sphere is "
    "left.",
    "spheres that grow with their distance from the origin of the world",
    return (Quadratic){q.a, q.b, q.c - vec3_dot(sphere.center, sphere.center)})
OF_WORLD("Q-cc-sign", "c = p.p - 2 p.C - C.C - r^2",
         "for an eye at the world's origin the squared distance would be -C.C, which is negative.",
         "spheres that grow with their distance from the origin of the world",
         return (Quadratic){q.a, q.b, q.c - 2 * vec3_dot(sphere.center, sphere.center)})

WRONG(world_quadratic, "Q-v", "v - C instead of v",
      "a direction is a difference of two points. Seen from the centre it is the same.",
      "spheres bent and out of place, except one at the origin of the world")
{
    ray.direction -= sphere.center;
    return right(ray, sphere);
}

// ---- wrong roots: slips in the formula itself ---------------------------------------------------

// The case with the slip: q.a != 0 and the discriminant is not negative.
static bool two_roots(Quadratic q)
{
    return q.a != 0 && discriminant(q) >= 0;
}

// With their own discriminant, which also decides how many there are.
static Roots with_discriminant(Quadratic q, double d)
{
    if (q.a == 0)
        return line_root(q);
    if (d < 0)
        return no_roots;
    return in_order((-q.b - sqrt(d)) / (2 * q.a), (-q.b + sqrt(d)) / (2 * q.a));
}

// With the square root of the discriminant.
#define OF_ROOT(id, formula, why, picture, ...)                                                    \
    WRONG(quadratic_roots, id, formula, why, picture)                                              \
    {                                                                                              \
        double root = sqrt(discriminant(q));                                                       \
        __VA_ARGS__;                                                                               \
    }

OF_ROOT("R1", "t = (-b +- sqrt(D)) / 2 * a",
        "C evaluates from left to right: it divides by 2, then multiplies by a. If v has length 1, "
        "so a = 1, you do not see it.",
        "the right outlines at wrong depths",
        return two_roots(q) ? in_order((-q.b - root) / 2 * q.a, (-q.b + root) / 2 * q.a) : slide(q))
OF_ROOT("R1-2", "t = (-b +- sqrt(D)) / a", "this goes twice as far along the ray as the sphere is.",
        "the right outlines, everything twice as far",
        return two_roots(q) ? in_order((-q.b - root) / q.a, (-q.b + root) / q.a) : slide(q))
OF_ROOT("R1-a", "t = (-b +- sqrt(D)) / 2",
        "a longer v needs a smaller t, but a is missing here. If v has length 1, so a = 1, you do "
        "not see it.",
        "the right outlines at wrong depths",
        return two_roots(q) ? in_order((-q.b - root) / 2, (-q.b + root) / 2) : slide(q))

WRONG(quadratic_roots, "R1-b", "t = -b +- sqrt(D) / (2a)",
      "C divides before it adds, so only the square root is divided. The whole numerator needs "
      "parentheses.",
      "the right outlines, everything much too far")
{
    double half = sqrt(discriminant(q)) / (2 * q.a);
    return two_roots(q) ? in_order(-q.b - half, -q.b + half) : slide(q);
}

WRONG_LINE(quadratic_roots, "R2", "D = b^2 - ac",
           "this discriminant is for half of b, but b here is the whole one.", "bloated spheres",
           double d = q.b * q.b - q.a * q.c;
           return with_discriminant(q, d))

WRONG_LINE(quadratic_roots, "R2-half", "D = (b/2)^2 - ac, t = (-b +- sqrt(D)) / (2a)",
           "D is for half of b, the rest for the whole b: the two places are only half as far "
           "apart as they should be.",
           "the right outlines, but flatter spheres",
           return with_discriminant(q, q.b / 2 * (q.b / 2) - q.a * q.c))

OF_ROOT(
    "R2-whole", "t = (-b/2 +- sqrt(D)) / a",
    "this formula needs the D of half b, and this D is of the whole b: the two places are twice "
    "as far apart as they should be.",
    "the right outlines, but spheres that bulge towards the eye",
    return two_roots(q) ? in_order((-q.b / 2 - root) / q.a, (-q.b / 2 + root) / q.a) : slide(q))

WRONG_LINE(quadratic_roots, "R2-plus", "D = b^2 + 4ac",
           "seen from outside the sphere this is never negative, so no ray can miss.",
           "a picture filled by the sphere: every ray hits", double d = q.b * q.b + 4 * q.a * q.c;
           return with_discriminant(q, d))

WRONG_LINE(
    quadratic_roots, "R2-c", "D = b^2 - 4c",
    "the length of v also decides whether the ray meets the sphere, so a must be in D. If v has "
    "length 1, so a = 1, you do not see it.",
    "bloated spheres, or spheres too small if v is short", double d = q.b * q.b - 4 * q.c;
    return with_discriminant(q, d))

OF_ROOT("R4", "t = (b +- sqrt(D)) / (2a)",
        "these roots belong to the ray in the opposite direction: places ahead come out behind.",
        "a blank picture",
        return two_roots(q) ? in_order((q.b - root) / (2 * q.a), (q.b + root) / (2 * q.a))
                            : slide(q))

WRONG(quadratic_roots, "R-sqrt", "t = (-b +- D) / (2a)",
      "D is a square, like b^2, and cannot be added to b.", "the right outlines at wrong depths")
{
    double d = discriminant(q);
    return two_roots(q) ? in_order((-q.b - d) / (2 * q.a), (-q.b + d) / (2 * q.a)) : slide(q);
}

WRONG_LINE(quadratic_roots, "R-abs", "sqrt(|D|)",
           "a negative D says that the ray misses the sphere. With |D| you invent two places that "
           "are not on the sphere.",
           "a picture filled by the sphere: every ray hits",
           return with_discriminant(q, fabs(discriminant(q))))

WRONG(quadratic_roots, "R-same", "both roots with - sqrt(D)",
      "a line that enters a sphere also leaves it, at another place.",
      "a sphere that vanishes as soon as the eye is inside")
{
    double t = (-q.b - sqrt(discriminant(q))) / (2 * q.a);
    return two_roots(q) ? (Roots){2, {t, t}} : slide(q);
}

// q = -(b + sqrt(D)) / 2, ignoring the sign of b; then c / q divides by 0.
WRONG(quadratic_roots, "R-q", "q = -(b + sqrt(D)) / 2, q/a and c/q",
      "for a negative b the two terms cancel, and if nothing is left, c/q is infinite or NaN. That "
      "is why q depends on the sign of b.",
      "single wrong pixels, more of them on distant spheres")
{
    double sum = -(q.b + sqrt(discriminant(q))) / 2;
    return two_roots(q) ? in_order(sum / q.a, q.c / sum) : slide(q);
}

// Wrong roots of students who have the formula but not its special cases yet: no line for a = 0,
// the order as computed; and the sign of D ignored, or already checked.

// The root t with this sign of the square root, and d as it is assumed to be: CHECKED refuses a
// negative one, BARE does not.
#define ROOTS(d_is, root_is)                                                                       \
    d_is;                                                                                          \
    double both[2];                                                                                \
    for (int i = 0; i < 2; i++) {                                                                  \
        double t, sign = 2 * i - 1;                                                                \
        root_is;                                                                                   \
        both[i] = t;                                                                               \
    }
#define CHECKED(id, formula, why, picture, d_is, root_is)                                          \
    WRONG(quadratic_roots, id, formula, why, picture)                                              \
    {                                                                                              \
        ROOTS(d_is, root_is);                                                                      \
        return d < 0 ? no_roots : (Roots){2, {both[0], both[1]}};                                  \
    }
#define BARE(id, formula, why, picture, d_is, root_is)                                             \
    WRONG(quadratic_roots, id, formula, why, picture)                                              \
    {                                                                                              \
        ROOTS(d_is, root_is);                                                                      \
        return (Roots){2, {both[0], both[1]}};                                                     \
    }
#define BOTH(id, formula, why, picture, d_is, root_is)                                             \
    CHECKED(id "-plain", formula, why, picture, d_is, root_is)                                     \
    BARE(id "-bare", formula, why, picture, d_is, root_is)

CHECKED("R-plain", "(-b - sqrt(D)) / (2a) always first",
        "right for a > 0, and rays need no more. For a < 0 this is the larger root, and a = 0 "
        "divides by 0: then it is a line.",
        "no visible difference, because for a ray and a sphere a is positive",
        double d = discriminant(q), t = (-q.b + sign * sqrt(d)) / (2 * q.a))
BARE("R-bare", "(-b +- sqrt(D)) / (2a), whatever a and D are",
     "a negative D has no square root: the ray misses the sphere. And a may be negative, which "
     "reverses the order, or 0.",
     "no visible difference, by luck: nan > 0 is false, so hit_sphere treats it as a miss",
     double d = discriminant(q), t = (-q.b + sign * sqrt(d)) / (2 * q.a))
BOTH("R-plus", "first with +, then with - sqrt(D)",
     "for a > 0 this is the larger root first, but t[0] must be the smaller one.",
     "the inside of every sphere", double d = discriminant(q),
     t = (-q.b + -sign * sqrt(d)) / (2 * q.a))
BOTH("R1", "t = (-b +- sqrt(D)) / 2 * a",
     "C evaluates from left to right: it divides by 2, then multiplies by a. If v has length 1, so "
     "a = 1, you do not see it.",
     "the right outlines at wrong depths", double d = discriminant(q),
     t = (-q.b + sign * sqrt(d)) / 2 * q.a)
BOTH("R1-b", "t = -b +- sqrt(D) / (2a)",
     "C divides before it adds, so only the square root is divided. The whole numerator needs "
     "parentheses.",
     "the right outlines, everything much too far", double d = discriminant(q),
     t = -q.b + sign * sqrt(d) / (2 * q.a))
BOTH("R1-none", "t = -b +- sqrt(D) / 2 * a",
     "C divides and multiplies from left to right, and adds last. The numerator needs parentheses, "
     "and so does the denominator.",
     "the right outlines, everything much too far", double d = discriminant(q),
     t = -q.b + sign * sqrt(d) / 2 * q.a)
BOTH("R2", "D = b^2 - ac", "this discriminant is for half of b, but b here is the whole one.",
     "bloated spheres", double d = q.b * q.b - q.a * q.c, t = (-q.b + sign * sqrt(d)) / (2 * q.a))
BOTH("R2-plus", "D = b^2 + 4ac",
     "seen from outside the sphere this is never negative, so no ray can miss.",
     "a picture filled by the sphere: every ray hits", double d = q.b * q.b + 4 * q.a * q.c,
     t = (-q.b + sign * sqrt(d)) / (2 * q.a))
BOTH("R4", "t = (b +- sqrt(D)) / (2a)",
     "these roots belong to the ray in the opposite direction: places ahead come out behind.",
     "a blank picture", double d = discriminant(q), t = (q.b + sign * sqrt(d)) / (2 * q.a))
BOTH("R-sqrt", "t = (-b +- D) / (2a)", "D is a square, like b^2, and cannot be added to b.",
     "the right outlines at wrong depths", double d = discriminant(q),
     t = (-q.b + sign * d) / (2 * q.a))

// ---- wrong roots: their number, their order, and those for a = 0 --------------------------------

#define NOT_OF_SPHERES "no visible difference, because for a ray and a sphere a is never 0"

WRONG_LINE(quadratic_roots, "R5", "roots only if D > 0",
           "D = 0 is the ray that just touches the sphere: both places are equal, but it is a hit.",
           "hardly anything: single pixels missing at the edge",
           return q.a != 0 && discriminant(q) == 0 ? no_roots : slide(q))

WRONG(quadratic_roots, "R5-once", "one root if D = 0",
      "both places are equal, but they still count as two: only a line, a = 0, has a single root.",
      "hardly anything: single pixels missing at the edge")
{
    Roots roots = slide(q);
    if (roots.count == 2 && roots.t[0] == roots.t[1])
        roots.count = 1;
    return roots;
}

WRONG(quadratic_roots, "R-order", "first with -, then with + sqrt(D)",
      "dividing by a negative a reverses their order.",
      "no visible difference, because for a ray and a sphere a is positive")
{
    double d = discriminant(q);
    if (q.a == 0 || d < 0)
        return slide(q);
    return (Roots){2, {(-q.b - sqrt(d)) / (2 * q.a), (-q.b + sqrt(d)) / (2 * q.a)}};
}

WRONG(quadratic_roots, "R-down", "the larger root first",
      "the eye sees the place that comes first along the ray, and hit_sphere expects it in t[0].",
      "the inside of every sphere")
{
    Roots roots = slide(q);
    return roots.count < 2 ? roots : (Roots){2, {roots.t[1], roots.t[0]}};
}

WRONG(quadratic_roots, "R-real", "t = -b / (2a) if D < 0",
      "this is where the ray comes closest to the sphere, but it misses the sphere.",
      "a picture filled by the sphere: every ray hits")
{
    double middle = -q.b / (2 * q.a);
    return q.a != 0 && discriminant(q) < 0 ? (Roots){2, {middle, middle}} : slide(q);
}

WRONG_LINE(
    quadratic_roots, "R-nan", "sqrt(D) even if D < 0",
    "this gives NaN. A negative D means that the ray misses the sphere, and there are no roots.",
    "no visible difference, by luck: nan > 0 is false, so hit_sphere treats it as a miss",
    return q.a != 0 && discriminant(q) < 0 ? (Roots){2, {NAN, NAN}} : slide(q))

OF_ROOT("R-a0", "/ (2a) even if a = 0",
        "this divides by 0. Without t^2 the parabola is a straight line: solve b t + c = 0.",
        NOT_OF_SPHERES,
        return q.a == 0 ? (Roots){2, {(-q.b - root) / (2 * q.a), (-q.b + root) / (2 * q.a)}}
                        : slide(q))

WRONG_LINE(quadratic_roots, "R-line", "no roots if a = 0",
           "a straight line is left, and it crosses 0 once unless it is level.", NOT_OF_SPHERES,
           return q.a == 0 ? no_roots : slide(q))
WRONG_LINE(quadratic_roots, "R-line2", "two equal roots if a = 0",
           "a straight line crosses 0 once; unlike a parabola, it does not touch it.",
           NOT_OF_SPHERES,
           return q.a == 0 && q.b != 0 ? (Roots){2, {-q.c / q.b, -q.c / q.b}} : slide(q))
WRONG_LINE(quadratic_roots, "R-sign", "t = c / b if a = 0",
           "put it into b t + c: the result is 2c, but it must be 0.", NOT_OF_SPHERES,
           return q.a == 0 && q.b != 0 ? (Roots){1, {q.c / q.b}} : slide(q))
WRONG_LINE(quadratic_roots, "R-zero", "t = -c / b even if b = 0",
           "this divides by 0. With a = b = 0 the line is level and never crosses 0.",
           NOT_OF_SPHERES, return q.a == 0 ? (Roots){1, {-q.c / q.b}} : slide(q))
WRONG_LINE(quadratic_roots, "R-all", "t = 0 if a = b = c = 0",
           "0 = 0 holds for every t, so there is no single root to return.", NOT_OF_SPHERES,
           return q.a == 0 && q.b == 0 && q.c == 0 ? (Roots){1, {0}} : slide(q))

WRONG(quadratic_roots, "R-ahead", "only the roots above 0",
      "hit_sphere decides which places are ahead of the eye. The equation has both roots.",
      "no visible difference, until a caller needs the hits of the whole line")
{
    Roots roots = slide(q);
    if (roots.count == 2 && roots.t[0] <= 0)
        return roots.t[1] > 0 ? (Roots){1, {roots.t[1]}} : no_roots;
    return roots;
}

WRONG_LINE(quadratic_roots, "R-b0", "no roots if b = 0",
           "b = 0 says only that the ray starts where it is closest to the centre; the two places "
           "are then on opposite sides.",
           "a sphere that vanishes if the eye is at its centre",
           return q.b == 0 ? no_roots : slide(q))

// ---- wrong places where a line meets a sphere ---------------------------------------------------

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

WRONG_LINE(sphere_roots, "Q7-roots", "a, b, c of the ray in world coordinates",
           "without the step to object coordinates this is a sphere at the origin of the world.",
           "every sphere at the origin of the world",
           return quadratic_roots(object_quadratic(ray, sphere.radius)))

WRONG(sphere_roots, "S-unit", "v / |v|, and its roots",
      "these roots are lengths in the world, but the caller needs t in lengths of v.",
      "the right outlines at wrong depths")
{
    ray.direction = vec3_unit(ray.direction);
    return slide_for_spheres(ray, sphere);
}

// From the right roots.
#define OF_ROOTS(id, formula, why, picture, ...)                                                   \
    WRONG(sphere_roots, id, formula, why, picture)                                                 \
    {                                                                                              \
        Roots roots = slide_for_spheres(ray, sphere);                                              \
        __VA_ARGS__;                                                                               \
    }

OF_ROOTS("S-ahead", "nothing if both roots are behind",
         "this function returns the places of the whole line. hit_sphere decides which are ahead.",
         "no visible difference, until a caller needs the places behind",
         return roots.count == 2 && roots.t[1] <= 0 ? no_roots : roots)
OF_ROOTS(
    "S-inside", "only the root ahead, from inside",
    "the line also meets the sphere behind the eye, and this function returns the places of the "
    "whole line.",
    "no visible difference, until a caller needs the places behind",
    return roots.count == 2 && roots.t[0] < 0 && roots.t[1] > 0 ? (Roots){1, {roots.t[1]}} : roots)
OF_ROOTS("R5-sphere", "a miss if the line just touches",
         "at l = r both places are equal, but the line does touch the sphere.",
         "hardly anything: single pixels missing at the edge",
         return roots.count == 2 && roots.t[0] == roots.t[1] ? no_roots : roots)
OF_ROOTS("S-once", "one root if the line just touches",
         "both places are equal, but they still count as two.",
         "hardly anything: single pixels missing at the edge",
         return roots.count == 2 && roots.t[0] == roots.t[1] ? (Roots){1, {roots.t[0]}} : roots)
OF_ROOTS("S-always", "t = -p.v / v.v if it misses",
         "this is where the line is closest to the sphere, and it does not meet the sphere there.",
         "a picture filled by the sphere: every ray hits",
         double middle = -vec3_dot(ray.origin - sphere.center, ray.direction) /
                         vec3_dot(ray.direction, ray.direction);
         return roots.count == 0 ? (Roots){2, {middle, middle}} : roots)

WRONG(sphere_roots, "S-double", "2r instead of r",
      "r is the distance from the centre to the surface, not from side to side.",
      "spheres of twice the size")
{
    sphere.radius *= 2;
    return slide_for_spheres(ray, sphere);
}

OF_ROOTS(
    "S-down", "the far place first",
    "the eye sees the place that comes first along the ray, and hit_sphere expects it in t[0].",
    "the inside of every sphere",
    return roots.count == 2 ? (Roots){2, {roots.t[1], roots.t[0]}} : roots)

WRONG(
    sphere_roots, "S-float", "a, b, c as float",
    "a float has 7 digits, and too few of them are left in p.p - r^2 for a sphere some radii away.",
    "rough, speckled spheres in the distance")
{
    Quadratic q = object_quadratic(to_object_coordinates(ray, sphere), sphere.radius);
    return slide((Quadratic){(float)q.a, (float)q.b, (float)q.c});
}

WRONG_LINE(sphere_roots, "S-chord", "t = -p.v / v.v +- sqrt(r^2 - l^2)",
           "the first part is in lengths of v, but half the chord is a length in the world. "
           "Convert one before you add them.",
           "the right outlines, but spheres too flat or too deep",
           return by_closest_approach(ray, sphere, foot_of(ray, sphere),
                                      half_chord_of(ray, sphere)))
WRONG_LINE(sphere_roots, "S-chord-a", "t = (-p.v +- sqrt(r^2 - l^2)) / v.v",
           "v.v is the squared length of v. Half the chord is a plain length: divide it by |v|.",
           "the right outlines, but spheres too flat or too deep",
           return by_closest_approach(ray, sphere, foot_of(ray, sphere),
                                      half_chord_of(ray, sphere) /
                                          vec3_dot(ray.direction, ray.direction)))

WRONG(sphere_roots, "S-foot", "closest approach at t = -p.v",
      "this is true only if v has length 1. With a longer one the point is beyond the sphere.",
      "a blank picture, or distorted spheres")
{
    double foot = -vec3_dot(ray.origin - sphere.center, ray.direction);
    double l = vec3_length(ray.origin + foot * ray.direction - sphere.center);
    return by_closest_approach(ray, sphere, foot,
                               sqrt((sphere.radius - l) * (sphere.radius + l)) /
                                   vec3_length(ray.direction));
}

WRONG(sphere_roots, "S-square", "half chord = r - l",
      "the radius, l and half the chord are the sides of a right-angled triangle, so the squares "
      "add up.",
      "the right outlines, but pointed where spheres should be round")
{
    double l = vec3_length(ray.origin + foot_of(ray, sphere) * ray.direction - sphere.center);
    return by_closest_approach(ray, sphere, foot_of(ray, sphere),
                               (sphere.radius - l) / vec3_length(ray.direction));
}

// ---- wrong hits: the wrong place, or a place that is not ahead ----------------------------------

static double first_root_above(Roots roots, double least)
{
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > least)
            return roots.t[i];
    return NO_HIT;
}

static double first_root_even_behind(Ray ray, Sphere s)
{
    Roots roots = sphere_roots(ray, s);
    return roots.count > 0 ? roots.t[0] : NO_HIT;
}

// All in one function, with one slip.
static Quadratic equation(Ray ray, Sphere s)
{
    return object_quadratic(to_object_coordinates(ray, s), s.radius);
}

// Of the right roots, another one.
#define OF_HITS(id, formula, why, picture, ...)                                                    \
    WRONG(hit_sphere, id, formula, why, picture)                                                   \
    {                                                                                              \
        Roots roots = sphere_roots(ray, sphere);                                                   \
        __VA_ARGS__;                                                                               \
    }

OF_HITS("R6", "the far root",
        "the ray arrives at the near place first, and the sphere hides the far one.",
        "the inside of every sphere",
        return roots.count > 0 && roots.t[1] > 0 ? roots.t[1] : NO_HIT)

WRONG_BY(first_root_even_behind, hit_sphere, "R7", "t[0], even if it is not above 0",
         "places with t < 0 are behind the eye, and it cannot see them.",
         "ghosts of objects behind the eye")

WRONG(hit_sphere, "R7-far", "t[0] if it is above 0, else t[1]",
      "t[1] may also be behind the eye, if the whole sphere is behind it.",
      "ghosts of objects behind the eye")
{
    Roots roots = sphere_roots(ray, sphere);
    if (roots.count == 0)
        return NO_HIT;
    return roots.t[0] > 0 ? roots.t[0] : roots.t[1];
}

OF_HITS(
    "R8", "a miss if t[0] is not above 0",
    "from inside the sphere only the entry is behind the eye. The place where the ray leaves is "
    "ahead.",
    "a sphere that vanishes as soon as the eye is inside",
    return roots.count > 0 && roots.t[0] > 0 ? roots.t[0] : NO_HIT)

WRONG_LINE(hit_sphere, "R10", "only t > 0.1",
           "t is not a distance: it counts in lengths of v. A tenth of v can be a long way, and "
           "every nearer hit is lost.",
           "holes in objects close to the eye",
           return first_root_above(sphere_roots(ray, sphere), 0.1))
WRONG_LINE(hit_sphere, "R10-small", "only t > 0.001",
           "rays that start on a surface need such a limit; these start at the eye, and it sees "
           "objects close to it.",
           "holes in objects very close to the eye",
           return first_root_above(sphere_roots(ray, sphere), 0.001))
WRONG_LINE(
    hit_sphere, "D1", "only t > 1",
    "t = 1 is on the image plane, but the eye also sees objects between itself and the plane.",
    "near spheres vanish, or show their inside",
    return first_root_above(sphere_roots(ray, sphere), 1))
WRONG_LINE(hit_sphere, "T-zero", "t >= 0",
           "t = 0 is the eye itself, and a visible place is ahead of it.",
           "the whole picture covered by a sphere that the eye just touches",
           return first_root_above(sphere_roots(ray, sphere), -1e-300))

OF_HITS("R5-hit", "a miss if both roots are equal",
        "such a ray just touches the sphere, and that is a hit.",
        "hardly anything: single pixels missing at the edge",
        bool touches = roots.count == 2 && roots.t[0] == roots.t[1];
        return touches ? NO_HIT : first_root_above(roots, 0))

WRONG(hit_sphere, "T-minus1", "-1 instead of NO_HIT",
      "a search for the smallest t finds -1 nearer than every sphere. NO_HIT is farther than all "
      "of them.",
      "a blank picture, or only the sphere that is last in the scene")
{
    double t = hit_sphere(ray, sphere);
    return t < NO_HIT ? t : -1;
}

WRONG(hit_sphere, "T-none0", "0 instead of NO_HIT",
      "a search for the smallest t finds 0 nearer than every sphere. NO_HIT is farther than all of "
      "them.",
      "a blank picture, or only the sphere that is last in the scene")
{
    double t = hit_sphere(ray, sphere);
    return t < NO_HIT ? t : 0;
}

WRONG_LINE(hit_sphere, "T-way", "t |v|",
           "this is the distance to the place in the world. t counts in lengths of v, so that p + "
           "tv is the place.",
           "the right outlines at wrong depths",
           return hit_sphere(ray, sphere) * vec3_length(ray.direction))
WRONG_LINE(hit_sphere, "T-abs", "|t|",
           "a negative t is behind the eye, and a positive sign does not bring it to the front.",
           "objects behind the eye appear ahead of it",
           return fabs(first_root_even_behind(ray, sphere)))

OF_HITS("T-middle", "-b / (2a)",
        "this is where the ray is closest to the centre, deep inside the sphere.",
        "the right outlines, filled with flat discs", double middle = (roots.t[0] + roots.t[1]) / 2;
        return roots.count > 0 && middle > 0 ? middle : NO_HIT)

WRONG(hit_sphere, "Q7-hit", "the ray in world coordinates, without the centre",
      "this is a sphere at the origin of the world.", "every sphere at the origin of the world")
{
    sphere.center = vec3_of(0, 0, 0);
    return hit_sphere(ray, sphere);
}

WRONG(hit_sphere, "T-count", "t[0] and t[1], whatever count says",
      "if count is 0, the numbers in them mean nothing.",
      "a picture filled by the sphere: every ray hits")
{
    Roots roots = sphere_roots(ray, sphere);
    if (roots.t[0] > 0)
        return roots.t[0];
    return roots.t[1] > 0 ? roots.t[1] : roots.t[0];
}

WRONG_LINE(hit_sphere, "T-first", "t[0], whatever count says",
           "if count is 0, the number in it means nothing, and if t[0] is behind the eye, t[1] may "
           "be ahead.",
           "a picture filled by the sphere: every ray hits", return sphere_roots(ray, sphere).t[0])

OF_HITS("T-surface", "a miss if t[0] is 0",
        "the ray starts on the surface there, but it may run through the sphere and hit the other "
        "side.",
        "a sphere that vanishes when the eye touches it",
        return roots.count > 0 && roots.t[0] == 0 ? NO_HIT : first_root_above(roots, 0))

WRONG(hit_sphere, "Q1-hit", "b = p.v, with D = b^2 - 4ac",
      "this D needs the whole b, and p.v is only half of it.", "holes, or a blank picture")
{
    Quadratic q = equation(ray, sphere);
    return first_root_above(slide((Quadratic){q.a, q.b / 2, q.c}), 0);
}

WRONG(hit_sphere, "Q5-hit", "a = 1",
      "this is true only if v has length 1. The v of a pixel's ray ends on the image plane, so it "
      "is longer.",
      "distorted spheres, bloated if v is long")
{
    Quadratic q = equation(ray, sphere);
    return first_root_above(slide((Quadratic){1, q.b, q.c}), 0);
}

WRONG(hit_sphere, "R1-hit", "(-b - sqrt(D)) / 2 * a",
      "C evaluates from left to right: it divides by 2, then multiplies by a. If v has length 1, "
      "so a = 1, you do not see it.",
      "the right outlines at wrong depths")
{
    Quadratic q = equation(ray, sphere);
    return first_root_above(slide(q), 0) * q.a * q.a;
}

// Right in part: answers with a limit of their own, for the sizes that their authors thought of (a
// length is neither small nor large in itself, only compared with another one); and those that
// forget one of three components.

// ---- quadratic_roots ----------------------------------------------------------------------------

static const double tiny = 1e-6;

static Roots in_float(Quadratic q)
{
    float a = (float)q.a, b = (float)q.b, c = (float)q.c;
    if (a == 0)
        return b == 0 ? no_roots : (Roots){1, {-c / b}};
    float d = b * b - 4 * a * c, root = sqrtf(d);
    return d < 0 ? no_roots : in_order((-b - root) / (2 * a), (-b + root) / (2 * a));
}

// ---- sphere_roots, hit_sphere -------------------------------------------------------------------

static double first_root_between(Ray ray, Sphere s, double least, double most)
{
    Roots roots = slide_for_spheres(ray, s);
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > least && roots.t[i] < most)
            return roots.t[i];
    return NO_HIT;
}

// ---- a, b, c ------------------------------------------------------------------------------------

static Quadratic equation_in_float(Ray ray, double radius)
{
    float a = 0, b = 0, c = -(float)radius * (float)radius;
    for (int i = 0; i < 3; i++) {
        float p = (float)ray.origin[i], v = (float)ray.direction[i];
        a += v * v;
        b += 2 * p * v;
        c += p * p;
    }
    return (Quadratic){a, b, c};
}

// ---- two of three components --------------------------------------------------------------------

// Sums of two products instead of three: the result is a circle in the plane of x and y.
static vec3 without_z(vec3 v)
{
    return vec3_of(v[0], v[1], 0);
}

static Quadratic z_left_out(Ray ray, double radius)
{
    return object_quadratic((Ray){without_z(ray.origin), without_z(ray.direction)}, radius);
}

#define TWO_OF_THREE                                                                               \
    "a dot product is the sum of three products, and the product of the z components is missing."

#define SEVEN_DIGITS "a float has 7 digits, and squares and differences use them up. Use double."

WRONG_LINE(
    quadratic_roots, "R-a-tiny", "a line if |a| < 1e-6",
    "with a short direction a is small, but the parabola still bends. It is a line only if a is 0.",
    "whole scenes lost if they are large and the directions short",
    return fabs(q.a) < tiny ? line_root(q) : slide(q))
WRONG_LINE(quadratic_roots, "R-b-tiny", "no root if a = 0 and |b| < 1e-6",
           "a line that rises slowly still crosses 0, only farther away.",
           "no visible difference, because for a ray and a sphere a is never 0",
           return q.a == 0 && fabs(q.b) < tiny ? no_roots : slide(q))

WRONG(quadratic_roots, "R-D-tiny", "one place if |D| < 1e-6",
      "the size of D depends on the size of a, b and c. For a small sphere or a short direction D "
      "is always small.",
      "small spheres drawn as flat discs, and too large")
{
    double middle = -q.b / (2 * q.a);
    return q.a != 0 && fabs(discriminant(q)) < tiny ? (Roots){2, {middle, middle}} : slide(q);
}

WRONG_LINE(quadratic_roots, "R5-tiny", "roots only if D > 1e-6",
           "the size of D depends on the size of a, b and c. For a small sphere or a short "
           "direction D is always small.",
           "small spheres vanish", return q.a != 0 && discriminant(q) < tiny ? no_roots : slide(q))
WRONG_BY(in_float, quadratic_roots, "R-float", "the formula in float", SEVEN_DIGITS,
         "speckles, and ragged edges")

OF_ROOTS("S-tiny", "nothing if t[1] - t[0] is below 1e-6",
         "with a long direction the whole sphere is that short in t.",
         "spheres vanish if the directions are long",
         return roots.count == 2 && !(roots.t[1] - roots.t[0] > tiny) ? no_roots : roots)

WRONG_LINE(hit_sphere, "R10-micro", "only t > 0.000001",
           "rays that start on a surface need such a limit; these start at the eye. And t counts "
           "in lengths of v: with a long v the whole scene is nearer than that.",
           "spheres vanish if the directions are long",
           return first_root_between(ray, sphere, 1e-6, NO_HIT))
WRONG_LINE(hit_sphere, "R10-nano", "only t > 0.000000001",
           "rays that start on a surface need such a limit; these start at the eye. And t counts "
           "in lengths of v: with a long v the whole scene is nearer than that.",
           "no visible difference, until the directions are very long",
           return first_root_between(ray, sphere, 1e-9, NO_HIT))
WRONG_LINE(hit_sphere, "T-limit", "only t < 1000",
           "the eye sees at any distance: t counts in lengths of v, and with a short v everything "
           "is farther than that.",
           "distant spheres vanish", return first_root_between(ray, sphere, 0, 1000))
WRONG_LINE(hit_sphere, "T-limit-far", "only t < 1000000",
           "the eye sees at any distance: t counts in lengths of v, and with a short v everything "
           "is farther than that.",
           "very distant spheres vanish", return first_root_between(ray, sphere, 0, 1e6))

WRONG(hit_sphere, "T-float", "the formula in float", SEVEN_DIGITS, "speckles, and ragged edges")
{
    Roots roots = in_float(object_quadratic(to_object_coordinates(ray, sphere), sphere.radius));
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > 0)
            return roots.t[i];
    return NO_HIT;
}

WRONG_BY(equation_in_float, object_quadratic, "Q-float", "a, b, c in float", SEVEN_DIGITS,
         "speckles, and ragged edges")
WRONG_LINE(world_quadratic, "Q-float-world", "a, b, c in float", SEVEN_DIGITS,
           "speckles, and ragged edges",
           return equation_in_float(to_object_coordinates(ray, sphere), sphere.radius))

OF_OBJECT("Q5-tiny", "a at least 1e-6",
          "a is 0 only for a v of length 0, which no ray has. For a short v it is small.",
          "spheres out of shape if the directions are short", q.a = fmax(q.a, tiny);
          return q)

WRONG(
    to_object_coordinates, "O-z", "z unchanged",
    "x and y are seen from the centre of the sphere, but z is not. A vector has three components.",
    "spheres moved along z to the origin of the world")
{
    sphere.center[2] = 0;
    return (Ray){ray.origin - sphere.center, ray.direction};
}

WRONG_BY(z_left_out, object_quadratic, "Q-z", "x and y only", TWO_OF_THREE,
         "endless tubes instead of spheres")

OF_OBJECT("Q-z-a", "a = v_x^2 + v_y^2", TWO_OF_THREE, "distorted spheres, or none",
          q.a = z_left_out(object_ray, radius).a;
          return q)
OF_OBJECT("Q-z-b", "b = 2 (p_x v_x + p_y v_y)", TWO_OF_THREE, "distorted spheres, or none",
          q.b = z_left_out(object_ray, radius).b;
          return q)
OF_OBJECT("Q-z-c", "c = p_x^2 + p_y^2 - r^2", TWO_OF_THREE, "distorted spheres, or none",
          q.c = z_left_out(object_ray, radius).c;
          return q)

WRONG_LINE(world_quadratic, "Q-z-world", "x and y only", TWO_OF_THREE,
           "endless tubes instead of spheres",
           return z_left_out(to_object_coordinates(ray, sphere), sphere.radius))

// ---- answers that are right except for their last digits ----------------------------------------

//  Only the extra tests, which cost no marks, can distinguish them from right ones; hence the X in
//  front.

WRONG_BY(slide, quadratic_roots, "X-slide", "t = (-b +- sqrt(D)) / (2a)",
         "right, and good enough for full marks. If -b and sqrt(D) nearly cancel, digits are lost.",
         "no visible difference, except for small spheres very far away")

// The stable sum, but without care for the discriminant or the range.
WRONG(quadratic_roots, "X-sum", "q/a and c/q, with the sign of b",
      "right, and nothing cancels in q. But digits still cancel in D = b^2 - 4ac, and it overflows "
      "for large numbers.",
      "no visible difference, except for small spheres very far away")
{
    double d = discriminant(q), sum = -(q.b + copysign(sqrt(d), q.b)) / 2;
    if (q.a == 0 || d < 0)
        return slide(q);
    return sum == 0 ? (Roots){2, {0, 0}} : in_order(sum / q.a, q.c / sum);
}

WRONG_BY(slide_for_spheres, sphere_roots, "X-sphere", "the roots of a, b, c by the slide",
         "right, and good enough for full marks. Far from a small sphere, r^2 loses its digits "
         "beside p.p, and then again in D.",
         "speckled or missing spheres, a million radii away")
WRONG_LINE(sphere_roots, "X-stable", "stable roots of the slide's a, b, c",
           "right, and the roots are as careful as possible. But they cannot recover the digits "
           "that c = p.p - r^2 has lost.",
           "speckled or missing spheres, ten million radii away",
           return quadratic_roots(object_quadratic(to_object_coordinates(ray, sphere),
                                                   sphere.radius)))

// Measured from the foot of the perpendicular, but squares leave the range of a double.
WRONG(sphere_roots, "X-scale", "t = -p.v / v.v +- sqrt(r^2 - l^2) / |v|",
      "right, and good for distant spheres. But squares of the largest and smallest numbers leave "
      "the range of a double.",
      "no visible difference in any scene that can be drawn")
{
    vec3 p = ray.origin - sphere.center, v = ray.direction;
    double foot = -vec3_dot(p, v) / vec3_dot(v, v), l = vec3_length(p + foot * v);
    if (!(l <= sphere.radius))
        return no_roots;
    double half = sqrt((sphere.radius - l) * (sphere.radius + l)) / vec3_length(v);
    return (Roots){2, {foot - half, foot + half}};
}
