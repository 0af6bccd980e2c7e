// mistakes-plain.c - wrong roots of those who have the formula and not yet what lies at its
// edges: no line where a = 0, the order as it comes; and no look at the sign of D, or that already.
#include "tests/05-quadratic/mistakes.h"

// From slip(q, d, sign), the root with this sign of the square root; and D as it is taken to be.
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
            "right for a > 0, and that is all that rays need. For a < 0 it is the larger one, and "
            "a = 0 divides by 0: what remains is a line.",
            "nothing amiss, since for a ray and a sphere a is positive"),
    MISTAKE("R-bare", quadratic_roots, right_bare, "(-b +- sqrt(D)) / (2a), whatever a and D are",
            "a negative D has no square root: the ray passes beside. And a may be negative, which "
            "turns the order round, or 0.",
            "nothing amiss, by luck: nan > 0 is false, so hit_sphere takes it for a miss"),
    BOTH("R-plus", plus_first, "first with +, then with - sqrt(D)",
         "for a > 0 that is the larger root first, and t[0] is to be the smaller one.",
         "the inside of every sphere"),
    BOTH("R1", halved_then_times_a, "t = (-b +- sqrt(D)) / 2 * a",
         "C goes from left to right: it divides by 2, then multiplies by a. With a v of length 1, "
         "so a = 1, it does not show.",
         "the right outlines at wrong depths"),
    BOTH("R1-b", b_not_divided, "t = -b +- sqrt(D) / (2a)",
         "C divides before it adds, so that only the square root is divided. All that is above the "
         "fraction bar needs parentheses.",
         "the right outlines, everything much too far"),
    BOTH("R1-none", no_parentheses, "t = -b +- sqrt(D) / 2 * a",
         "C divides and multiplies from left to right, and adds last. What is above the fraction "
         "bar needs parentheses, and so does what is below it.",
         "the right outlines, everything much too far"),
    BOTH("R2", less_ac, "D = b^2 - ac",
         "this goes with half of b, and the b here is the whole one.", "bloated spheres"),
    BOTH("R2-plus", plus_4ac, "D = b^2 + 4ac",
         "seen from outside the sphere this is never negative, so that no ray can miss.",
         "a picture filled by the sphere: every ray hits"),
    BOTH("R4", plus_b, "t = (b +- sqrt(D)) / (2a)",
         "these roots belong to the ray that runs the other way: what is ahead comes out behind.",
         "a blank picture"),
    BOTH("R-sqrt", root_not_taken, "t = (-b +- D) / (2a)",
         "D is a square, like b^2, and cannot be added to b.",
         "the right outlines at wrong depths"),
    {0},
};
