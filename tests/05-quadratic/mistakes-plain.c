// mistakes-plain.c - wrong roots of students who have the formula but not its special cases yet: no
// line for a = 0, the order as computed; and the sign of D ignored, or already checked.
#include "tests/05-quadratic/mistakes.h"

// From slip(q, d, sign), the root with this sign of the square root; and D as it is assumed to be.
#define PLAIN(slip, D)                                                                             \
    static Roots slip##_checked(Quadratic q)                                                       \
    {                                                                                              \
        double d = D;                                                                              \
        return d < 0 ? no_roots : (Roots){2, {slip(q, d, -1), slip(q, d, 1)}};                     \
    }                                                                                              \
    static Roots slip##_bare(Quadratic q)                                                          \
    {                                                                                              \
        double d = D;                                                                              \
        return (Roots){2, {slip(q, d, -1), slip(q, d, 1)}};                                        \
    }

static double right(Quadratic q, double d, double sign)
{
    return (-q.b + sign * sqrt(d)) / (2 * q.a);
}

static double plus_first(Quadratic q, double d, double sign)
{
    return right(q, d, -sign);
}

static double halved_then_times_a(Quadratic q, double d, double sign)
{
    return (-q.b + sign * sqrt(d)) / 2 * q.a;
}

static double b_not_divided(Quadratic q, double d, double sign)
{
    return -q.b + sign * sqrt(d) / (2 * q.a);
}

static double no_parentheses(Quadratic q, double d, double sign)
{
    return -q.b + sign * sqrt(d) / 2 * q.a;
}

static double plus_b(Quadratic q, double d, double sign)
{
    return (q.b + sign * sqrt(d)) / (2 * q.a);
}

static double root_not_taken(Quadratic q, double d, double sign)
{
    return (-q.b + sign * d) / (2 * q.a);
}

static double less_ac(Quadratic q, double d, double sign)
{
    return right(q, d, sign);
}

static double plus_4ac(Quadratic q, double d, double sign)
{
    return right(q, d, sign);
}

PLAIN(right, discriminant(q))
PLAIN(plus_first, discriminant(q))
PLAIN(halved_then_times_a, discriminant(q))
PLAIN(b_not_divided, discriminant(q))
PLAIN(no_parentheses, discriminant(q))
PLAIN(plus_b, discriminant(q))
PLAIN(root_not_taken, discriminant(q))
PLAIN(less_ac, q.b *q.b - q.a * q.c)
PLAIN(plus_4ac, q.b *q.b + 4 * q.a * q.c)

// The two rows of the table for such a slip.
#define BOTH(id, slip, formula, why, picture)                                                      \
    MISTAKE(id "-plain", quadratic_roots, slip##_checked, formula, why, picture),                  \
        MISTAKE(id "-bare", quadratic_roots, slip##_bare, formula, why, picture)

const Mistake plain_mistakes[] = {
    MISTAKE("R-plain", quadratic_roots, right_checked, "(-b - sqrt(D)) / (2a) always first",
            "right for a > 0, and rays need no more. For a < 0 this is the larger root, and a = 0 "
            "divides by 0: then it is a line.",
            "no visible difference, because for a ray and a sphere a is positive"),
    MISTAKE("R-bare", quadratic_roots, right_bare, "(-b +- sqrt(D)) / (2a), whatever a and D are",
            "a negative D has no square root: the ray misses the sphere. And a may be negative, "
            "which reverses the order, or 0.",
            "no visible difference, by luck: nan > 0 is false, so hit_sphere treats it as a miss"),
    BOTH("R-plus", plus_first, "first with +, then with - sqrt(D)",
         "for a > 0 this is the larger root first, but t[0] must be the smaller one.",
         "the inside of every sphere"),
    BOTH("R1", halved_then_times_a, "t = (-b +- sqrt(D)) / 2 * a",
         "C evaluates from left to right: it divides by 2, then multiplies by a. If v has length "
         "1, so a = 1, you do not see it.",
         "the right outlines at wrong depths"),
    BOTH("R1-b", b_not_divided, "t = -b +- sqrt(D) / (2a)",
         "C divides before it adds, so only the square root is divided. The whole numerator needs "
         "parentheses.",
         "the right outlines, everything much too far"),
    BOTH("R1-none", no_parentheses, "t = -b +- sqrt(D) / 2 * a",
         "C divides and multiplies from left to right, and adds last. The numerator needs "
         "parentheses, and so does the denominator.",
         "the right outlines, everything much too far"),
    BOTH("R2", less_ac, "D = b^2 - ac",
         "this discriminant is for half of b, but b here is the whole one.", "bloated spheres"),
    BOTH("R2-plus", plus_4ac, "D = b^2 + 4ac",
         "seen from outside the sphere this is never negative, so no ray can miss.",
         "a picture filled by the sphere: every ray hits"),
    BOTH("R4", plus_b, "t = (b +- sqrt(D)) / (2a)",
         "these roots belong to the ray in the opposite direction: places ahead come out behind.",
         "a blank picture"),
    BOTH("R-sqrt", root_not_taken, "t = (-b +- D) / (2a)",
         "D is a square, like b^2, and cannot be added to b.",
         "the right outlines at wrong depths"),
    {0},
};
