// mistakes-formula.c - wrong roots: slips in the formula itself.
#include "tests/05-quadratic/mistakes.h"

// The case with the slip: q.a != 0 and the discriminant is not negative.
static bool two_roots(Quadratic q)
{
    return q.a != 0 && discriminant(q) >= 0;
}

static Roots halved_then_times_a(Quadratic q)
{
    double root = sqrt(discriminant(q));
    return two_roots(q) ? in_order((-q.b - root) / 2 * q.a, (-q.b + root) / 2 * q.a) : slide(q);
}

static Roots not_divided_by_2(Quadratic q)
{
    double root = sqrt(discriminant(q));
    return two_roots(q) ? in_order((-q.b - root) / q.a, (-q.b + root) / q.a) : slide(q);
}

static Roots not_divided_by_a(Quadratic q)
{
    double root = sqrt(discriminant(q));
    return two_roots(q) ? in_order((-q.b - root) / 2, (-q.b + root) / 2) : slide(q);
}

static Roots b_not_divided(Quadratic q)
{
    double half = sqrt(discriminant(q)) / (2 * q.a);
    return two_roots(q) ? in_order(-q.b - half, -q.b + half) : slide(q);
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

static Roots b_squared_less_ac(Quadratic q)
{
    return with_discriminant(q, q.b * q.b - q.a * q.c);
}

static Roots half_b_in_the_discriminant(Quadratic q)
{
    return with_discriminant(q, q.b / 2 * (q.b / 2) - q.a * q.c);
}

static Roots b_squared_plus_4ac(Quadratic q)
{
    return with_discriminant(q, q.b * q.b + 4 * q.a * q.c);
}

static Roots a_left_out_of_the_discriminant(Quadratic q)
{
    return with_discriminant(q, q.b * q.b - 4 * q.c);
}

static Roots half_b_before_the_root(Quadratic q)
{
    double root = sqrt(discriminant(q));
    return two_roots(q) ? in_order((-q.b / 2 - root) / q.a, (-q.b / 2 + root) / q.a) : slide(q);
}

static Roots plus_b(Quadratic q)
{
    double root = sqrt(discriminant(q));
    return two_roots(q) ? in_order((q.b - root) / (2 * q.a), (q.b + root) / (2 * q.a)) : slide(q);
}

static Roots root_not_taken(Quadratic q)
{
    double d = discriminant(q);
    return two_roots(q) ? in_order((-q.b - d) / (2 * q.a), (-q.b + d) / (2 * q.a)) : slide(q);
}

static Roots absolute_discriminant(Quadratic q)
{
    return with_discriminant(q, fabs(discriminant(q)));
}

static Roots same_sign_twice(Quadratic q)
{
    double t = (-q.b - sqrt(discriminant(q))) / (2 * q.a);
    return two_roots(q) ? (Roots){2, {t, t}} : slide(q);
}

// q = -(b + sqrt(D)) / 2, ignoring the sign of b; then c / q divides by 0.
static Roots sum_without_sign(Quadratic q)
{
    double sum = -(q.b + sqrt(discriminant(q))) / 2;
    return two_roots(q) ? in_order(sum / q.a, q.c / sum) : slide(q);
}

const Mistake formula_mistakes[] = {
    MISTAKE("R1", quadratic_roots, halved_then_times_a, "t = (-b +- sqrt(D)) / 2 * a",
            "C evaluates from left to right: it divides by 2, then multiplies by a. If v has "
            "length 1, so a = 1, you do not see it.",
            "the right outlines at wrong depths"),
    MISTAKE("R1-2", quadratic_roots, not_divided_by_2, "t = (-b +- sqrt(D)) / a",
            "this goes twice as far along the ray as the sphere is.",
            "the right outlines, everything twice as far"),
    MISTAKE("R1-a", quadratic_roots, not_divided_by_a, "t = (-b +- sqrt(D)) / 2",
            "a longer v needs a smaller t, but a is missing here. If v has length 1, so a = 1, you "
            "do not see it.",
            "the right outlines at wrong depths"),
    MISTAKE("R1-b", quadratic_roots, b_not_divided, "t = -b +- sqrt(D) / (2a)",
            "C divides before it adds, so only the square root is divided. The whole numerator "
            "needs parentheses.",
            "the right outlines, everything much too far"),
    MISTAKE("R2", quadratic_roots, b_squared_less_ac, "D = b^2 - ac",
            "this discriminant is for half of b, but b here is the whole one.", "bloated spheres"),
    MISTAKE("R2-half", quadratic_roots, half_b_in_the_discriminant,
            "D = (b/2)^2 - ac, t = (-b +- sqrt(D)) / (2a)",
            "D is for half of b, the rest for the whole b: the two places are only half as far "
            "apart as they should be.",
            "the right outlines, but flatter spheres"),
    MISTAKE("R2-whole", quadratic_roots, half_b_before_the_root, "t = (-b/2 +- sqrt(D)) / a",
            "this formula needs the D of half b, and this D is of the whole b: the two places are "
            "twice as far apart as they should be.",
            "the right outlines, but spheres that bulge towards the eye"),
    MISTAKE("R2-plus", quadratic_roots, b_squared_plus_4ac, "D = b^2 + 4ac",
            "seen from outside the sphere this is never negative, so no ray can miss.",
            "a picture filled by the sphere: every ray hits"),
    MISTAKE("R2-c", quadratic_roots, a_left_out_of_the_discriminant, "D = b^2 - 4c",
            "the length of v also decides whether the ray meets the sphere, so a must be in D. If "
            "v has length 1, so a = 1, you do not see it.",
            "bloated spheres, or spheres too small if v is short"),
    MISTAKE(
        "R4", quadratic_roots, plus_b, "t = (b +- sqrt(D)) / (2a)",
        "these roots belong to the ray in the opposite direction: places ahead come out behind.",
        "a blank picture"),
    MISTAKE("R-sqrt", quadratic_roots, root_not_taken, "t = (-b +- D) / (2a)",
            "D is a square, like b^2, and cannot be added to b.",
            "the right outlines at wrong depths"),
    MISTAKE("R-abs", quadratic_roots, absolute_discriminant, "sqrt(|D|)",
            "a negative D says that the ray misses the sphere. With |D| you invent two places that "
            "are not on the sphere.",
            "a picture filled by the sphere: every ray hits"),
    MISTAKE("R-same", quadratic_roots, same_sign_twice, "both roots with - sqrt(D)",
            "a line that enters a sphere also leaves it, at another place.",
            "a sphere that vanishes as soon as the eye is inside"),
    MISTAKE("R-q", quadratic_roots, sum_without_sign, "q = -(b + sqrt(D)) / 2, q/a and c/q",
            "for a negative b the two terms cancel, and if nothing is left, c/q is infinite or "
            "NaN. That is why q depends on the sign of b.",
            "single wrong pixels, more of them on distant spheres"),
    {0},
};
