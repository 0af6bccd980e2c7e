// wrong.c - wrong answers to exercise 05.
#include "exercises/05-quadratic.h"

#include "tests/judge/known.h"

// ---- to_object_coordinates ----------------------------------------------------------------------

WRONG_LINE(to_object_coordinates, "Q7", "p unchanged",
           "this is the eye seen from the world's origin, but it must be seen from the center of "
           "the sphere.",
           "every sphere at the origin of the world", return ray)
WRONG_LINE(to_object_coordinates, "Q9", "p + C",
           "seen from the center, the eye moves in the opposite direction: subtract C.",
           "every sphere mirrored to the other side of the world's origin",
           return (Ray){ray.origin + sphere.center, ray.direction})
WRONG_LINE(
    to_object_coordinates, "O-eye", "C - p",
    "this is the center seen from the eye; the exercise asks for the eye seen from the center.",
    "nothing from in front of the eye, but the scene behind it",
    return (Ray){sphere.center - ray.origin, ray.direction})
WRONG_LINE(to_object_coordinates, "O-both", "p - C, and v - C as well",
           "a direction is a difference of two points. Seen from any other point it is the same.",
           "spheres bent and out of place, except one at the origin of the world",
           return (Ray){ray.origin - sphere.center, ray.direction - sphere.center})
WRONG_LINE(to_object_coordinates, "O-v", "p unchanged, and v - C",
           "seen from another point the ray has another origin, but the same direction.",
           "spheres bent and out of place, except one at the origin of the world",
           return (Ray){ray.origin, ray.direction - sphere.center})
WRONG_LINE(to_object_coordinates, "O-unit", "v / |v|",
           "it points in the right direction, but now t counts in lengths of 1: with the world's "
           "v, that t does not reach the sphere.",
           "the right outlines at wrong depths",
           return (Ray){ray.origin - sphere.center, vec3_unit(ray.direction)})
WRONG_LINE(to_object_coordinates, "O-radius", "(p - C) / r",
           "seen from the center the eye is as far away as in the world. Only the origin moves; "
           "nothing is scaled.",
           "large spheres too large and small ones too small",
           return (Ray){(ray.origin - sphere.center) / sphere.radius, ray.direction})
WRONG_LINE(
    to_object_coordinates, "O-z", "z unchanged",
    "x and y are seen from the center of the sphere, but z is not. A vector has three components.",
    "spheres moved along z to the origin of the world", sphere.center[2] = 0;
    return (Ray){ray.origin - sphere.center, ray.direction})

// ---- a, b, c ------------------------------------------------------------------------------------

// The right ones, of the eye seen from the center.
static Quadratic right(vec3 p, vec3 v, double r)
{
    return (Quadratic){vec3_dot(v, v), 2 * vec3_dot(p, v), vec3_dot(p, p) - r * r};
}

// a, b and c, made of the right ones; p is the eye seen from the center.
#define COEFFICIENTS(p_is, v_is, r_is, ...)                                                        \
    vec3 p = p_is, v = v_is;                                                                       \
    double r = r_is, a = right(p, v, r).a, b = right(p, v, r).b, c = right(p, v, r).c;             \
    (void)a, (void)b, (void)c;                                                                     \
    return (Quadratic)                                                                             \
    {                                                                                              \
        __VA_ARGS__                                                                                \
    }
#define OBJECT(id, formula, why, picture, ...)                                                     \
    WRONG(object_quadratic, id, formula, why, picture)                                             \
    {                                                                                              \
        COEFFICIENTS(object_ray.origin, object_ray.direction, radius, __VA_ARGS__);                \
    }
#define WORLD(id, formula, why, picture, ...)                                                      \
    WRONG(world_quadratic, id, formula, why, picture)                                              \
    {                                                                                              \
        vec3 eye = ray.origin, center = sphere.center;                                             \
        COEFFICIENTS(eye - center, ray.direction, sphere.radius, __VA_ARGS__);                     \
    }
#define OBJECT_AND_WORLD(id, formula, formula_in_world, why, picture, ...)                         \
    OBJECT(id, formula, why, picture, __VA_ARGS__)                                                 \
    WORLD(id "-world", formula_in_world, why, picture, __VA_ARGS__)

// Sums of two products instead of three: with them a sphere is a circle in the plane of x and y.
static double without_z(vec3 v, vec3 w)
{
    return v[0] * w[0] + v[1] * w[1];
}

static float dot_in_float(float start, vec3 v, vec3 w)
{
    for (int i = 0; i < 3; i++)
        start += (float)v[i] * (float)w[i];
    return start;
}

static const double tiny = 1e-6;

#define TWO_OF_THREE                                                                               \
    "a dot product is the sum of three products, and the product of the z components is missing."
#define SEVEN_DIGITS "a float has 7 digits, and squares and differences use them up. Use double."

OBJECT_AND_WORLD("Q4", "c = p.p + r^2", "c = |p - C|^2 + r^2",
                 "at t = 0 only c is left, so for an eye on the surface it must be 0; this c is "
                 "never 0.",
                 "a blank picture", a, b, vec3_dot(p, p) + r * r)
OBJECT_AND_WORLD("Q-point", "c = p.p", "c = |p - C|^2",
                 "without its radius a sphere is only its center, and hardly any ray hits a point.",
                 "a blank picture", a, b, vec3_dot(p, p))
OBJECT_AND_WORLD("Q5", "a = 1", "a = 1",
                 "this is true only if v has length 1. The v of a pixel's ray ends on the image "
                 "plane, so it is longer.",
                 "distorted spheres, bloated if v is long", 1, b, c)
OBJECT_AND_WORLD("Q5-root", "a = |v|", "a = |v|",
                 "all lengths in this equation are squared, also that of v. If v has length 1, you "
                 "do not see it.",
                 "distorted spheres, bloated if v is long", vec3_length(v), b, c)
OBJECT_AND_WORLD("Q-lengths", "a = |v|, c = |p| - r^2", "a = |v|, c = |p - C| - r^2",
                 "the dot product of a vector with itself is the square of its length, and all "
                 "lengths in this equation are squared.",
                 "distorted spheres that fill the picture", vec3_length(v), b,
                 vec3_length(p) - r * r)
OBJECT_AND_WORLD("Q-z", "x and y only", "x and y only", TWO_OF_THREE,
                 "endless tubes instead of spheres", without_z(v, v), 2 * without_z(p, v),
                 without_z(p, p) - r * r)
OBJECT_AND_WORLD("Q-float", "a, b, c in float", "a, b, c in float", SEVEN_DIGITS,
                 "speckles, and ragged edges", dot_in_float(0, v, v), 2 * dot_in_float(0, p, v),
                 dot_in_float(-(float)r *(float)r, p, p))

OBJECT("Q1", "b = p.v", "multiply out (p + tv).(p + tv): p.v occurs twice.",
       "holes, or a blank picture", a, b / 2, c)
OBJECT("Q2", "b = -2 p.v", "with this sign, points ahead on the ray come out behind its origin.",
       "spheres vanish, and those behind the eye appear", a, -b, c)
OBJECT("Q2-angle", "b = 2 |p| |v|",
       "this is their dot product only if p and v have the same direction. The angle between them "
       "counts, and an obtuse one makes b negative.",
       "a blank picture", a, 2 * vec3_length(p) * vec3_length(v), c)
OBJECT("Q3", "c = p.p - r",
       "p.p is a squared length and r is a length: square r. If r is 1, you do not see it.",
       "spheres of the wrong size, except those of radius 1", a, b, vec3_dot(p, p) - r)
OBJECT("Q3-length", "c = |p| - r",
       "these are plain lengths, but the terms with t^2 and t are squared lengths.",
       "bloated spheres that fill the picture", a, b, vec3_length(p) - r)
OBJECT("Q4-sign", "c = r^2 - p.p",
       "multiplying the equation by -1 changes every sign, but a and b kept theirs.",
       "a picture filled by the sphere: every ray hits", a, b, -c)
OBJECT("Q-abs", "c made positive",
       "for an eye inside the sphere c is negative, and that puts one root ahead of it and the "
       "other behind.",
       "a sphere that vanishes as soon as the eye is inside", a, b, fabs(c))
OBJECT("Q-p", "c = |p| - r^2", "|p| is a length and r^2 a squared length. Use p.p, which is |p|^2.",
       "bloated spheres that fill the picture", a, b, vec3_length(p) - r * r)
OBJECT("Q-swap", "a and c swapped",
       "a multiplies t^2; c alone is left of the equation at t = 0, where the ray starts.",
       "the right outlines, but far objects cover near ones", c, b, a)
// Instead of the dot product: components multiplied, and the first one taken.
OBJECT("Q-dot", "only the x of every product",
       "p * v multiplies component by component; a dot product is the sum of all three.",
       "a wall instead of the sphere: every ray hits", (v * v)[0], 2 * (p * v)[0],
       (p * p)[0] - r * r)
OBJECT("Q5-tiny", "a at least 1e-6",
       "a is 0 only for a v of length 0, which no ray has. For a short v it is small.",
       "spheres out of shape if the directions are short", fmax(a, tiny), b, c)
OBJECT("Q-z-a", "a = v_x^2 + v_y^2", TWO_OF_THREE, "distorted spheres, or none", without_z(v, v), b,
       c)
OBJECT("Q-z-b", "b = 2 (p_x v_x + p_y v_y)", TWO_OF_THREE, "distorted spheres, or none", a,
       2 * without_z(p, v), c)
OBJECT("Q-z-c", "c = p_x^2 + p_y^2 - r^2", TWO_OF_THREE, "distorted spheres, or none", a, b,
       without_z(p, p) - r * r)

// ---- a, b, c in the world: places where the center is lost --------------------------------------

WRONG_LINE(world_quadratic, "Q7-world", "b = 2 p.v, c = p.p - r^2",
           "the center is missing in both, so this is a sphere at the origin of the world.",
           "every sphere at the origin of the world",
           return right(ray.origin, ray.direction, sphere.radius))
WRONG_LINE(world_quadratic, "Q9-world", "b = 2 (p + C).v, c = |p + C|^2 - r^2",
           "the length of p + C is the distance from p to -C, and the sphere is not there.",
           "every sphere mirrored to the other side of the world's origin",
           return right(ray.origin + sphere.center, ray.direction, sphere.radius))
WORLD("Q2-world", "b = 2 (C - p).v",
      "with this sign, points ahead on the ray come out behind its origin. c is right, because "
      "squares ignore the sign; b is not.",
      "spheres vanish, and those behind the eye appear", a, -b, c)
WORLD("Q1-world", "b = p.v - C.v", "square p - C + tv: the product of p - C with v occurs twice.",
      "holes, or a blank picture", a, b / 2, c)
WORLD("Q1-half", "b = 2 p.v - C.v",
      "only the eye's part is doubled. If eye and sphere move together nothing may change, but "
      "here b does.",
      "spheres of the wrong size in the wrong places, except one at the origin of the world", a,
      b + vec3_dot(center, v), c)
WORLD("Q-b", "b = 2 p.v", "c knows the center but b does not: they describe two different spheres.",
      "spheres of the wrong size in the wrong places, except one at the origin of the world", a,
      2 * vec3_dot(eye, v), c)
WORLD("Q9-b", "b = 2 (p.v + C.v)", "c measures from the center, but b from the opposite point, -C.",
      "spheres of the wrong size in the wrong places, except one at the origin of the world", a,
      2 * vec3_dot(eye + center, v), c)
WORLD("Q3-world", "c = |p - C|^2 - r",
      "one is a squared length, the other a length. If r is 1, you do not see it.",
      "spheres of the wrong size, except those of radius 1", a, b, c + r * r - r)
// |p - C|^2 = |p|^2 - |C|^2
WORLD("Q-squares", "c = p.p - C.C - r^2",
      "p.p - C.C is 0 if eye and center are equally far from the world's origin, however far they "
      "are from each other.",
      "spheres far too large, except one at the origin of the world", a, b,
      vec3_dot(eye, eye) - vec3_dot(center, center) - r * r)
WORLD("Q-sum", "c = p.p + C.C - r^2",
      "this is the squared distance only if eye and center are at a right angle seen from the "
      "world's origin.",
      "spheres of the wrong size, except one at the origin of the world", a, b,
      c + 2 * vec3_dot(eye, center))
WORLD("Q-once", "c = p.p - p.C + C.C - r^2", "multiply out (p - C).(p - C): p.C occurs twice.",
      "spheres of the wrong size, except one at the origin of the world", a, b,
      c + vec3_dot(eye, center))
WORLD("Q9-c", "c = p.p + 2 p.C + C.C - r^2",
      "this measures the eye from -C, opposite to the center.",
      "spheres of the wrong size, except one at the origin of the world", a, b,
      c + 4 * vec3_dot(eye, center))
WORLD("Q-cc", "c = p.p - 2 p.C - r^2",
      "C.C is missing: for an eye at the world's origin nothing of the distance to the sphere is "
      "left.",
      "spheres that grow with their distance from the origin of the world", a, b,
      c - vec3_dot(center, center))
WORLD("Q-cc-sign", "c = p.p - 2 p.C - C.C - r^2",
      "for an eye at the world's origin the squared distance would be -C.C, which is negative.",
      "spheres that grow with their distance from the origin of the world", a, b,
      c - 2 * vec3_dot(center, center))
WRONG_LINE(world_quadratic, "Q-v", "v - C instead of v",
           "a direction is a difference of two points. Seen from the center it is the same.",
           "spheres bent and out of place, except one at the origin of the world",
           return right(ray.origin - sphere.center, ray.direction - sphere.center, sphere.radius))

// ---- quadratic_roots: slips in the formula ------------------------------------------------------

static const Roots no_roots = {0};

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

// The formula with a slip: d is as the mistake computes it, and so is the root with each sign of
// the square root of d. WITH_CASES has the line for a = 0, and roots in order.
#define ROOTS(d_is, root_is)                                                                       \
    double d = d_is, square_root = sqrt(d), both[2];                                               \
    for (int i = 0; i < 2; i++) {                                                                  \
        double sign = 2 * i - 1;                                                                   \
        both[i] = root_is;                                                                         \
        (void)sign, (void)square_root;                                                             \
    }
#define WITH_CASES(id, formula, why, picture, d_is, root_is)                                       \
    WRONG(quadratic_roots, id, formula, why, picture)                                              \
    {                                                                                              \
        ROOTS(d_is, root_is);                                                                      \
        if (q.a == 0)                                                                              \
            return line_root(q);                                                                   \
        return d < 0 ? no_roots : in_order(both[0], both[1]);                                      \
    }
// Students who do not have the special cases yet: CHECKED refuses a negative d, BARE does not.
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
#define WITHOUT_CASES(id, ...)                                                                     \
    CHECKED(id "-plain", __VA_ARGS__)                                                              \
    BARE(id "-bare", __VA_ARGS__)
#define WITH_AND_WITHOUT_CASES(id, ...)                                                            \
    WITH_CASES(id, __VA_ARGS__)                                                                    \
    WITHOUT_CASES(id, __VA_ARGS__)

WITH_AND_WITHOUT_CASES(
    "R1", "t = (-b +- sqrt(D)) / 2 * a",
    "C evaluates from left to right: it divides by 2, then multiplies by a. If v has length 1, so "
    "a = 1, you do not see it.",
    "the right outlines at wrong depths", discriminant(q), (-q.b + sign * square_root) / 2 * q.a)
WITH_AND_WITHOUT_CASES(
    "R1-b", "t = -b +- sqrt(D) / (2a)",
    "C divides before it adds, so only the square root is divided. The whole numerator needs "
    "parentheses.",
    "the right outlines, everything much too far", discriminant(q),
    -q.b + sign * square_root / (2 * q.a))
WITH_AND_WITHOUT_CASES("R2", "D = b^2 - ac",
                       "this discriminant is for half of b, but b here is the whole one.",
                       "bloated spheres", -q.a *q.c + q.b * q.b,
                       (-q.b + sign * square_root) / (2 * q.a))
WITH_AND_WITHOUT_CASES("R2-plus", "D = b^2 + 4ac",
                       "seen from outside the sphere this is never negative, so no ray can miss.",
                       "a picture filled by the sphere: every ray hits", 4 * q.a * q.c + q.b * q.b,
                       (-q.b + sign * square_root) / (2 * q.a))
WITH_AND_WITHOUT_CASES(
    "R4", "t = (b +- sqrt(D)) / (2a)",
    "these roots belong to the ray in the opposite direction: points ahead come out behind.",
    "a blank picture", discriminant(q), (q.b + sign * square_root) / (2 * q.a))
WITH_AND_WITHOUT_CASES("R-sqrt", "t = (-b +- D) / (2a)",
                       "D is a square, like b^2, and cannot be added to b.",
                       "the right outlines at wrong depths", discriminant(q),
                       (-q.b + sign * d) / (2 * q.a))
WITH_CASES("R1-2", "t = (-b +- sqrt(D)) / a",
           "this goes twice as far along the ray as the sphere is.",
           "the right outlines, everything twice as far", discriminant(q),
           (-q.b + sign * square_root) / q.a)
WITH_CASES("R1-a", "t = (-b +- sqrt(D)) / 2",
           "a longer v needs a smaller t, but a is missing here. If v has length 1, so a = 1, you "
           "do not see it.",
           "the right outlines at wrong depths", discriminant(q), (-q.b + sign * square_root) / 2)
WITH_CASES("R2-half", "D = (b/2)^2 - ac, t = (-b +- sqrt(D)) / (2a)",
           "D is for half of b, the rest for the whole b: the two roots are only half as far "
           "apart as they should be.",
           "the right outlines, but flatter spheres", q.b / 2 * (q.b / 2) - q.a * q.c,
           (-q.b + sign * square_root) / (2 * q.a))
WITH_CASES("R2-whole", "t = (-b/2 +- sqrt(D)) / a",
           "this formula needs the D of half b, and this D is of the whole b: the two roots are "
           "twice as far apart as they should be.",
           "the right outlines, but spheres that bulge towards the eye", discriminant(q),
           (-q.b / 2 + sign * square_root) / q.a)
WITH_CASES("R2-c", "D = b^2 - 4c",
           "the length of v also decides whether the ray meets the sphere, so a must be in D. If v "
           "has length 1, so a = 1, you do not see it.",
           "bloated spheres, or spheres too small if v is short", -4 * q.c + q.b * q.b,
           (-q.b + sign * square_root) / (2 * q.a))
WITH_CASES("R-abs", "sqrt(|D|)",
           "a negative D says that the ray misses the sphere. With |D| you invent two points that "
           "are not on the sphere.",
           "a picture filled by the sphere: every ray hits", fabs(discriminant(q)),
           (-q.b + sign * square_root) / (2 * q.a))
WITH_CASES("R-same", "both roots with - sqrt(D)",
           "a line that enters a sphere also leaves it, at another point.",
           "a sphere that vanishes as soon as the eye is inside", discriminant(q),
           (-q.b - square_root) / (2 * q.a))
// q = -(b + sqrt(D)) / 2, ignoring the sign of b; then c / q divides by 0.
WITH_CASES("R-q", "q = -(b + sqrt(D)) / 2, q/a and c/q",
           "for a negative b the two terms cancel, and if nothing is left, c/q is infinite or NaN. "
           "That is why q depends on the sign of b.",
           "single wrong pixels, more of them on distant spheres", discriminant(q),
           sign < 0 ? -(q.b + square_root) / 2 / q.a : q.c / (-(q.b + square_root) / 2))
CHECKED("R-plain", "(-b - sqrt(D)) / (2a) always first",
        "right for a > 0, and rays need no more. For a < 0 this is the larger root, and a = 0 "
        "divides by 0: then it is a line.",
        "no visible difference, because for a ray and a sphere a is positive", discriminant(q),
        (-q.b + sign * square_root) / (2 * q.a))
BARE("R-bare", "(-b +- sqrt(D)) / (2a), whatever a and D are",
     "a negative D has no square root: the ray misses the sphere. And a may be negative, which "
     "reverses the order, or 0.",
     "no visible difference, by luck: nan > 0 is false, so hit_sphere treats it as a miss",
     discriminant(q), (-q.b + sign * square_root) / (2 * q.a))
WITHOUT_CASES("R-plus", "first with +, then with - sqrt(D)",
              "for a > 0 this is the larger root first, but t[0] must be the smaller one.",
              "the inside of every sphere", discriminant(q),
              (-q.b + -sign * square_root) / (2 * q.a))
WITHOUT_CASES("R1-none", "t = -b +- sqrt(D) / 2 * a",
              "C divides and multiplies from left to right, and adds last. The numerator needs "
              "parentheses, and so does the denominator.",
              "the right outlines, everything much too far", discriminant(q),
              -q.b + sign * square_root / 2 * q.a)

// ---- quadratic_roots: how many there are, their order, and those for a = 0 ----------------------

#define NOT_OF_SPHERES "no visible difference, because for a ray and a sphere a is never 0"

// From the right roots; middle is between them.
#define OF_SLIDE(id, formula, why, picture, ...)                                                   \
    WRONG(quadratic_roots, id, formula, why, picture)                                              \
    {                                                                                              \
        Roots roots = slide(q);                                                                    \
        double d = discriminant(q), middle = -q.b / (2 * q.a);                                     \
        (void)d, (void)middle;                                                                     \
        return __VA_ARGS__;                                                                        \
    }

OF_SLIDE("R5", "roots only if D > 0",
         "D = 0 is the ray that just touches the sphere: both roots are equal, but it is a hit.",
         "hardly anything: single pixels missing at the edge",
         q.a != 0 && d == 0 ? no_roots : roots)
OF_SLIDE("R5-once", "one root if D = 0",
         "both roots are equal, but they still count as two: only a line, a = 0, has a single "
         "root.",
         "hardly anything: single pixels missing at the edge",
         roots.count == 2 && roots.t[0] == roots.t[1] ? (Roots){1, {roots.t[0]}} : roots)
OF_SLIDE("R5-tiny", "roots only if D > 1e-6",
         "the size of D depends on the size of a, b and c. For a small sphere or a short direction "
         "D is always small.",
         "small spheres vanish", q.a != 0 && d < tiny ? no_roots : roots)
OF_SLIDE("R-D-tiny", "one root if |D| < 1e-6",
         "the size of D depends on the size of a, b and c. For a small sphere or a short direction "
         "D is always small.",
         "small spheres drawn as flat discs, and too large",
         q.a != 0 && fabs(d) < tiny ? (Roots){2, {middle, middle}} : roots)
OF_SLIDE("R-real", "t = -b / (2a) if D < 0",
         "this is where the ray comes closest to the sphere, but it misses the sphere.",
         "a picture filled by the sphere: every ray hits",
         q.a != 0 && d < 0 ? (Roots){2, {middle, middle}} : roots)
OF_SLIDE("R-nan", "sqrt(D) even if D < 0",
         "this gives NaN. A negative D means that the ray misses the sphere, and there are no "
         "roots.",
         "no visible difference, by luck: nan > 0 is false, so hit_sphere treats it as a miss",
         q.a != 0 && d < 0 ? (Roots){2, {NAN, NAN}} : roots)
OF_SLIDE("R-order", "first with -, then with + sqrt(D)",
         "dividing by a negative a reverses their order.",
         "no visible difference, because for a ray and a sphere a is positive",
         roots.count == 2 && q.a < 0 ? (Roots){2, {roots.t[1], roots.t[0]}} : roots)
OF_SLIDE("R-down", "the larger root first",
         "the eye sees the point that comes first along the ray, and hit_sphere expects it in "
         "t[0].",
         "the inside of every sphere",
         roots.count == 2 ? (Roots){2, {roots.t[1], roots.t[0]}} : roots)
OF_SLIDE("R-ahead", "only the roots above 0",
         "hit_sphere decides which roots are ahead of the eye. The equation has both roots.",
         "no visible difference, until a caller needs the hits of the whole line",
         roots.count<2 || roots.t[0]> 0 ? roots
         : roots.t[1] > 0               ? (Roots){1, {roots.t[1]}}
                                        : no_roots)
OF_SLIDE("R-b0", "no roots if b = 0",
         "b = 0 says only that the ray starts where it is closest to the center; the two points "
         "are then on opposite sides.",
         "a sphere that vanishes if the eye is at its center", q.b == 0 ? no_roots : roots)
OF_SLIDE("R-a0", "/ (2a) even if a = 0",
         "this divides by 0. Without t^2 the parabola is a straight line: solve b t + c = 0.",
         NOT_OF_SPHERES,
         q.a == 0 ? (Roots){2, {(-q.b - sqrt(d)) / (2 * q.a), (-q.b + sqrt(d)) / (2 * q.a)}}
                  : roots)
OF_SLIDE("R-a-tiny", "a line if |a| < 1e-6",
         "with a short direction a is small, but the parabola still bends. It is a line only if a "
         "is 0.",
         "whole scenes lost if they are large and the directions short",
         fabs(q.a) < tiny ? line_root(q) : roots)
OF_SLIDE("R-line", "no roots if a = 0",
         "a straight line is left, and it crosses 0 once unless it is level.", NOT_OF_SPHERES,
         q.a == 0 ? no_roots : roots)
OF_SLIDE("R-line2", "two equal roots if a = 0",
         "a straight line crosses 0 once; unlike a parabola, it does not touch it.", NOT_OF_SPHERES,
         q.a == 0 && q.b != 0 ? (Roots){2, {-q.c / q.b, -q.c / q.b}} : roots)
OF_SLIDE("R-sign", "t = c / b if a = 0", "put it into b t + c: the result is 2c, but it must be 0.",
         NOT_OF_SPHERES, q.a == 0 && q.b != 0 ? (Roots){1, {q.c / q.b}} : roots)
OF_SLIDE("R-zero", "t = -c / b even if b = 0",
         "this divides by 0. With a = b = 0 the line is level and never crosses 0.", NOT_OF_SPHERES,
         q.a == 0 ? (Roots){1, {-q.c / q.b}} : roots)
OF_SLIDE("R-all", "t = 0 if a = b = c = 0",
         "0 = 0 holds for every t, so there is no single root to return.", NOT_OF_SPHERES,
         q.a == 0 && q.b == 0 && q.c == 0 ? (Roots){1, {0}} : roots)
OF_SLIDE("R-b-tiny", "no root if a = 0 and |b| < 1e-6",
         "a line that rises slowly still crosses 0, only farther away.", NOT_OF_SPHERES,
         q.a == 0 && fabs(q.b) < tiny ? no_roots : roots)

static Roots in_float(Quadratic q)
{
    float a = (float)q.a, b = (float)q.b, c = (float)q.c;
    if (a == 0)
        return b == 0 ? no_roots : (Roots){1, {-c / b}};
    float d = b * b - 4 * a * c, root = sqrtf(d);
    return d < 0 ? no_roots : in_order((-b - root) / (2 * a), (-b + root) / (2 * a));
}

WRONG_BY(in_float, quadratic_roots, "R-float", "the formula in float", SEVEN_DIGITS,
         "speckles, and ragged edges")

// ---- sphere_roots -------------------------------------------------------------------------------

static Quadratic equation(Ray ray, Sphere s)
{
    return object_quadratic(to_object_coordinates(ray, s), s.radius);
}

WRONG_LINE(sphere_roots, "Q7-roots", "a, b, c of the ray in world coordinates",
           "without the step to object coordinates this is a sphere at the origin of the world.",
           "every sphere at the origin of the world",
           return quadratic_roots(object_quadratic(ray, sphere.radius)))
WRONG_LINE(sphere_roots, "S-unit", "v / |v|, and its roots",
           "these roots are lengths in the world, but the caller needs t in lengths of v.",
           "the right outlines at wrong depths", ray.direction = vec3_unit(ray.direction);
           return slide(equation(ray, sphere)))
WRONG_LINE(sphere_roots, "S-double", "2r instead of r",
           "r is the distance from the center to the surface, not from side to side.",
           "spheres of twice the size", sphere.radius *= 2;
           return slide(equation(ray, sphere)))
WRONG_LINE(sphere_roots, "S-float", "a, b, c as float",
           "a float has 7 digits, and too few of them are left in p.p - r^2 for a sphere some "
           "radii away.",
           "rough, speckled spheres in the distance", Quadratic q = equation(ray, sphere);
           return slide((Quadratic){(float)q.a, (float)q.b, (float)q.c}))

// From the right roots.
#define OF_ROOTS(id, formula, why, picture, ...)                                                   \
    WRONG(sphere_roots, id, formula, why, picture)                                                 \
    {                                                                                              \
        Roots roots = slide(equation(ray, sphere));                                                \
        return __VA_ARGS__;                                                                        \
    }

OF_ROOTS("S-ahead", "nothing if both roots are behind",
         "this function returns the roots of the whole line. hit_sphere decides which are ahead.",
         "no visible difference, until a caller needs the points behind",
         roots.count == 2 && roots.t[1] <= 0 ? no_roots : roots)
OF_ROOTS("S-inside", "only the root ahead, from inside",
         "the line also meets the sphere behind the eye, and this function returns the roots of "
         "the whole line.",
         "no visible difference, until a caller needs the points behind",
         roots.count == 2 && roots.t[0] < 0 && roots.t[1] > 0 ? (Roots){1, {roots.t[1]}} : roots)
OF_ROOTS("R5-sphere", "a miss if the line just touches",
         "at m = r both roots are equal, but the line does touch the sphere.",
         "hardly anything: single pixels missing at the edge",
         roots.count == 2 && roots.t[0] == roots.t[1] ? no_roots : roots)
OF_ROOTS("S-once", "one root if the line just touches",
         "both roots are equal, but they still count as two.",
         "hardly anything: single pixels missing at the edge",
         roots.count == 2 && roots.t[0] == roots.t[1] ? (Roots){1, {roots.t[0]}} : roots)
OF_ROOTS("S-down", "the larger root first",
         "the eye sees the point that comes first along the ray, and hit_sphere expects it in "
         "t[0].",
         "the inside of every sphere",
         roots.count == 2 ? (Roots){2, {roots.t[1], roots.t[0]}} : roots)
OF_ROOTS("S-tiny", "nothing if t[1] - t[0] is below 1e-6",
         "with a long direction the whole sphere is that short in t.",
         "spheres vanish if the directions are long",
         roots.count == 2 && !(roots.t[1] - roots.t[0] > tiny) ? no_roots : roots)

static double foot_of(vec3 p, vec3 v)
{
    return -vec3_dot(p, v) / vec3_dot(v, v);
}

WRONG(sphere_roots, "S-always", "t = -p.v / v.v if it misses",
      "this is where the line is closest to the sphere, and it does not meet the sphere there.",
      "a picture filled by the sphere: every ray hits")
{
    Roots roots = slide(equation(ray, sphere));
    double foot = foot_of(ray.origin - sphere.center, ray.direction);
    return roots.count == 0 ? (Roots){2, {foot, foot}} : roots;
}

// By the closest approach, as the extra suggests: it is at t = foot, at the distance l from the
// center; half a chord is a length, and half is that in t.
#define BY_CLOSEST_APPROACH(id, formula, why, picture, foot_is, half_is)                           \
    WRONG(sphere_roots, id, formula, why, picture)                                                 \
    {                                                                                              \
        vec3 p = ray.origin - sphere.center, v = ray.direction;                                    \
        double r = sphere.radius, foot = foot_is, l = vec3_length(p + foot * v);                   \
        double half_chord = sqrt((r - l) * (r + l)), half = half_is;                               \
        (void)half_chord;                                                                          \
        return l <= r ? (Roots){2, {foot - half, foot + half}} : no_roots;                         \
    }

BY_CLOSEST_APPROACH("S-chord", "t = -p.v / v.v +- sqrt(r^2 - m^2)",
                    "the first part is in lengths of v, but half the chord is a length in the "
                    "world. Convert one before you add them.",
                    "the right outlines, but spheres too flat or too deep", foot_of(p, v),
                    half_chord)
BY_CLOSEST_APPROACH("S-chord-a", "t = (-p.v +- sqrt(r^2 - m^2)) / v.v",
                    "v.v is the squared length of v. Half the chord is a plain length: divide it "
                    "by |v|.",
                    "the right outlines, but spheres too flat or too deep", foot_of(p, v),
                    half_chord / vec3_dot(v, v))
BY_CLOSEST_APPROACH("S-foot", "closest approach at t = -p.v",
                    "this is true only if v has length 1. With a longer one the point is beyond "
                    "the sphere.",
                    "a blank picture, or distorted spheres", -vec3_dot(p, v),
                    half_chord / vec3_length(v))
BY_CLOSEST_APPROACH("S-square", "half chord = r - m",
                    "the radius, m and half the chord are the sides of a right-angled triangle, so "
                    "the squares add up.",
                    "the right outlines, but pointed where spheres should be round", foot_of(p, v),
                    (r - l) / vec3_length(v))

// ---- hit_sphere: the wrong point, or a point that is not ahead ----------------------------------

static double first_root_between(Roots roots, double least, double most)
{
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > least && roots.t[i] < most)
            return roots.t[i];
    return NO_HIT;
}

static double first_root_above(Roots roots, double least)
{
    return first_root_between(roots, least, NO_HIT);
}

// Of the right roots, another one.
#define OF_HITS(id, formula, why, picture, ...)                                                    \
    WRONG(hit_sphere, id, formula, why, picture)                                                   \
    {                                                                                              \
        Roots roots = sphere_roots(ray, sphere);                                                   \
        return __VA_ARGS__;                                                                        \
    }

OF_HITS("R6", "the far root",
        "the ray arrives at the near point first, and the sphere hides the far one.",
        "the inside of every sphere", roots.count > 0 && roots.t[1] > 0 ? roots.t[1] : NO_HIT)
OF_HITS("R7", "t[0], even if it is not above 0",
        "points with t < 0 are behind the eye, and it cannot see them.",
        "ghosts of objects behind the eye", roots.count > 0 ? roots.t[0] : NO_HIT)
OF_HITS("R7-far", "t[0] if it is above 0, else t[1]",
        "t[1] may also be behind the eye, if the whole sphere is behind it.",
        "ghosts of objects behind the eye",
        roots.count == 0 ? NO_HIT
        : roots.t[0] > 0 ? roots.t[0]
                         : roots.t[1])
OF_HITS("R8", "a miss if t[0] is not above 0",
        "from inside the sphere only the entry is behind the eye. The point where the ray leaves "
        "is ahead.",
        "a sphere that vanishes as soon as the eye is inside",
        roots.count > 0 && roots.t[0] > 0 ? roots.t[0] : NO_HIT)
OF_HITS("R10", "only t > 0.1",
        "t is not a distance: it counts in lengths of v. A tenth of v can be a long way, and every "
        "nearer hit is lost.",
        "holes in objects close to the eye", first_root_above(roots, 0.1))
OF_HITS("R10-small", "only t > 0.001",
        "rays that start on a surface need such a limit; these start at the eye, and it sees "
        "objects close to it.",
        "holes in objects very close to the eye", first_root_above(roots, 0.001))
OF_HITS("R10-micro", "only t > 0.000001",
        "rays that start on a surface need such a limit; these start at the eye. And t counts in "
        "lengths of v: with a long v the whole scene is nearer than that.",
        "spheres vanish if the directions are long", first_root_above(roots, 1e-6))
OF_HITS("R10-nano", "only t > 0.000000001",
        "rays that start on a surface need such a limit; these start at the eye. And t counts in "
        "lengths of v: with a long v the whole scene is nearer than that.",
        "no visible difference, until the directions are very long", first_root_above(roots, 1e-9))
OF_HITS("D1", "only t > 1",
        "t = 1 is on the image plane, but the eye also sees objects between itself and the plane.",
        "near spheres vanish, or show their inside", first_root_above(roots, 1))
OF_HITS("T-limit", "only t < 1000",
        "the eye sees at any distance: t counts in lengths of v, and with a short v everything is "
        "farther than that.",
        "distant spheres vanish", first_root_between(roots, 0, 1000))
OF_HITS("T-limit-far", "only t < 1000000",
        "the eye sees at any distance: t counts in lengths of v, and with a short v everything is "
        "farther than that.",
        "very distant spheres vanish", first_root_between(roots, 0, 1e6))
OF_HITS("T-zero", "t >= 0", "t = 0 is the eye itself, and a visible point is ahead of it.",
        "the whole picture covered by a sphere that the eye just touches",
        first_root_above(roots, -1e-300))
OF_HITS("R5-hit", "a miss if both roots are equal",
        "such a ray just touches the sphere, and that is a hit.",
        "hardly anything: single pixels missing at the edge",
        roots.count == 2 && roots.t[0] == roots.t[1] ? NO_HIT : first_root_above(roots, 0))
OF_HITS("T-surface", "a miss if t[0] is 0",
        "the ray starts on the surface there, but it may run through the sphere and hit the other "
        "side.",
        "a sphere that vanishes when the eye touches it",
        roots.count > 0 && roots.t[0] == 0 ? NO_HIT : first_root_above(roots, 0))
OF_HITS("T-abs", "|t|",
        "a negative t is behind the eye, and a positive sign does not bring it to the front.",
        "objects behind the eye appear ahead of it", roots.count > 0 ? fabs(roots.t[0]) : NO_HIT)
OF_HITS("T-middle", "-b / (2a)",
        "this is where the ray is closest to the center, deep inside the sphere.",
        "the right outlines, filled with flat discs",
        roots.count > 0 && roots.t[0] + roots.t[1] > 0 ? (roots.t[0] + roots.t[1]) / 2 : NO_HIT)
OF_HITS("T-count", "t[0] and t[1], whatever count says",
        "if count is 0, the numbers in them mean nothing.",
        "a picture filled by the sphere: every ray hits",
        roots.t[0] <= 0 && roots.t[1] > 0 ? roots.t[1] : roots.t[0])
OF_HITS("T-first", "t[0], whatever count says",
        "if count is 0, the number in it means nothing, and if t[0] is behind the eye, t[1] may be "
        "ahead.",
        "a picture filled by the sphere: every ray hits", roots.t[0])

// From the right t.
#define OF_T(id, formula, why, picture, ...)                                                       \
    WRONG(hit_sphere, id, formula, why, picture)                                                   \
    {                                                                                              \
        double t = hit_sphere(ray, sphere);                                                        \
        return __VA_ARGS__;                                                                        \
    }

OF_T("T-minus1", "-1 instead of NO_HIT",
     "a search for the smallest t finds -1 nearer than every sphere. NO_HIT is farther than all "
     "of them.",
     "a blank picture, or only the sphere that is last in the scene", t < NO_HIT ? t : -1)
OF_T("T-none0", "0 instead of NO_HIT",
     "a search for the smallest t finds 0 nearer than every sphere. NO_HIT is farther than all of "
     "them.",
     "a blank picture, or only the sphere that is last in the scene", t < NO_HIT ? t : 0)
OF_T("T-way", "t |v|",
     "this is the distance to the point in the world. t counts in lengths of v, so that p + tv is "
     "the point.",
     "the right outlines at wrong depths", vec3_length(ray.direction) * t)

// All in one function, with one slip.
#define ALL_IN_ONE(id, formula, why, picture, ...)                                                 \
    WRONG(hit_sphere, id, formula, why, picture)                                                   \
    {                                                                                              \
        Quadratic q = equation(ray, sphere);                                                       \
        return __VA_ARGS__;                                                                        \
    }

ALL_IN_ONE("Q1-hit", "b = p.v, with D = b^2 - 4ac",
           "this D needs the whole b, and p.v is only half of it.", "holes, or a blank picture",
           first_root_above(slide((Quadratic){q.a, q.b / 2, q.c}), 0))
ALL_IN_ONE("Q5-hit", "a = 1",
           "this is true only if v has length 1. The v of a pixel's ray ends on the image plane, "
           "so it is longer.",
           "distorted spheres, bloated if v is long",
           first_root_above(slide((Quadratic){1, q.b, q.c}), 0))
ALL_IN_ONE("R1-hit", "(-b - sqrt(D)) / 2 * a",
           "C evaluates from left to right: it divides by 2, then multiplies by a. If v has length "
           "1, so a = 1, you do not see it.",
           "the right outlines at wrong depths", first_root_above(slide(q), 0) * q.a * q.a)
ALL_IN_ONE("T-float", "the formula in float", SEVEN_DIGITS, "speckles, and ragged edges",
           first_root_above(in_float(q), 0))
WRONG_LINE(hit_sphere, "Q7-hit", "the ray in world coordinates, without the center",
           "this is a sphere at the origin of the world.",
           "every sphere at the origin of the world", sphere.center = vec3_of(0, 0, 0);
           return hit_sphere(ray, sphere))

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

WRONG_LINE(sphere_roots, "X-sphere", "the roots of a, b, c by the slide",
           "right, and good enough for full marks. Far from a small sphere, r^2 loses its digits "
           "beside p.p, and then again in D.",
           "speckled or missing spheres, a million radii away", return slide(equation(ray, sphere)))
WRONG_LINE(sphere_roots, "X-stable", "stable roots of the slide's a, b, c",
           "right, and the roots are as careful as possible. But they cannot recover the digits "
           "that c = p.p - r^2 has lost.",
           "speckled or missing spheres, ten million radii away",
           return quadratic_roots(equation(ray, sphere)))
// Measured from the foot of the perpendicular, but squares leave the range of a double.
BY_CLOSEST_APPROACH("X-scale", "t = -p.v / v.v +- sqrt(r^2 - m^2) / |v|",
                    "right, and good for distant spheres. But squares of the largest and smallest "
                    "numbers leave the range of a double.",
                    "no visible difference in any scene that can be drawn", foot_of(p, v),
                    half_chord / vec3_length(v))
