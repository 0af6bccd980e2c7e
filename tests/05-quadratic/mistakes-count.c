// mistakes-count.c - wrong roots: their number, their order, and those for a = 0.
#include "tests/05-quadratic/mistakes.h"

static Roots double_root_lost(Quadratic q)
{
    return q.a != 0 && discriminant(q) == 0 ? no_roots : slide(q);
}

static Roots double_root_once(Quadratic q)
{
    Roots roots = slide(q);
    if (roots.count == 2 && roots.t[0] == roots.t[1])
        roots.count = 1;
    return roots;
}

static Roots minus_before_plus(Quadratic q)
{
    double d = discriminant(q);
    if (q.a == 0 || d < 0)
        return slide(q);
    return (Roots){2, {(-q.b - sqrt(d)) / (2 * q.a), (-q.b + sqrt(d)) / (2 * q.a)}};
}

static Roots descending(Quadratic q)
{
    Roots roots = slide(q);
    return roots.count < 2 ? roots : (Roots){2, {roots.t[1], roots.t[0]}};
}

static Roots real_parts(Quadratic q)
{
    double middle = -q.b / (2 * q.a);
    return q.a != 0 && discriminant(q) < 0 ? (Roots){2, {middle, middle}} : slide(q);
}

static Roots discriminant_not_looked_at(Quadratic q)
{
    return q.a != 0 && discriminant(q) < 0 ? (Roots){2, {NAN, NAN}} : slide(q);
}

static Roots divided_by_0(Quadratic q)
{
    double root = sqrt(discriminant(q));
    return q.a == 0 ? (Roots){2, {(-q.b - root) / (2 * q.a), (-q.b + root) / (2 * q.a)}} : slide(q);
}

static Roots line_not_seen(Quadratic q)
{
    return q.a == 0 ? no_roots : slide(q);
}

static Roots line_with_two_roots(Quadratic q)
{
    return q.a == 0 && q.b != 0 ? (Roots){2, {-q.c / q.b, -q.c / q.b}} : slide(q);
}

static Roots line_of_the_wrong_sign(Quadratic q)
{
    return q.a == 0 && q.b != 0 ? (Roots){1, {q.c / q.b}} : slide(q);
}

static Roots level_line_divided_by_0(Quadratic q)
{
    return q.a == 0 ? (Roots){1, {-q.c / q.b}} : slide(q);
}

static Roots zero_equals_zero(Quadratic q)
{
    return q.a == 0 && q.b == 0 && q.c == 0 ? (Roots){1, {0}} : slide(q);
}

static Roots positive_roots_only(Quadratic q)
{
    Roots roots = slide(q);
    if (roots.count == 2 && roots.t[0] <= 0)
        return roots.t[1] > 0 ? (Roots){1, {roots.t[1]}} : no_roots;
    return roots;
}

static Roots nothing_where_b_is_0(Quadratic q)
{
    return q.b == 0 ? no_roots : slide(q);
}

#define NOT_OF_SPHERES "no visible difference, because for a ray and a sphere a is never 0"

const Mistake count_mistakes[] = {
    MISTAKE(
        "R5", quadratic_roots, double_root_lost, "roots only if D > 0",
        "D = 0 is the ray that just touches the sphere: both places are equal, but it is a hit.",
        "hardly anything: single pixels missing at the edge"),
    MISTAKE("R5-once", quadratic_roots, double_root_once, "one root if D = 0",
            "both places are equal, but they still count as two: only a line, a = 0, has a single "
            "root.",
            "hardly anything: single pixels missing at the edge"),
    MISTAKE("R-order", quadratic_roots, minus_before_plus, "first with -, then with + sqrt(D)",
            "dividing by a negative a reverses their order.",
            "no visible difference, because for a ray and a sphere a is positive"),
    MISTAKE(
        "R-down", quadratic_roots, descending, "the larger root first",
        "the eye sees the place that comes first along the ray, and hit_sphere expects it in t[0].",
        "the inside of every sphere"),
    MISTAKE("R-real", quadratic_roots, real_parts, "t = -b / (2a) if D < 0",
            "this is where the ray comes closest to the sphere, but it misses the sphere.",
            "a picture filled by the sphere: every ray hits"),
    MISTAKE("R-nan", quadratic_roots, discriminant_not_looked_at, "sqrt(D) even if D < 0",
            "this gives NaN. A negative D means that the ray misses the sphere, and there are no "
            "roots.",
            "no visible difference, by luck: nan > 0 is false, so hit_sphere treats it as a miss"),
    MISTAKE("R-a0", quadratic_roots, divided_by_0, "/ (2a) even if a = 0",
            "this divides by 0. Without t^2 the parabola is a straight line: solve b t + c = 0.",
            NOT_OF_SPHERES),
    MISTAKE("R-line", quadratic_roots, line_not_seen, "no roots if a = 0",
            "a straight line is left, and it crosses 0 once unless it is level.", NOT_OF_SPHERES),
    MISTAKE("R-line2", quadratic_roots, line_with_two_roots, "two equal roots if a = 0",
            "a straight line crosses 0 once; unlike a parabola, it does not touch it.",
            NOT_OF_SPHERES),
    MISTAKE("R-sign", quadratic_roots, line_of_the_wrong_sign, "t = c / b if a = 0",
            "put it into b t + c: the result is 2c, but it must be 0.", NOT_OF_SPHERES),
    MISTAKE("R-zero", quadratic_roots, level_line_divided_by_0, "t = -c / b even if b = 0",
            "this divides by 0. With a = b = 0 the line is level and never crosses 0.",
            NOT_OF_SPHERES),
    MISTAKE("R-all", quadratic_roots, zero_equals_zero, "t = 0 if a = b = c = 0",
            "0 = 0 holds for every t, so there is no single root to return.", NOT_OF_SPHERES),
    MISTAKE("R-ahead", quadratic_roots, positive_roots_only, "only the roots above 0",
            "hit_sphere decides which places are ahead of the eye. The equation has both roots.",
            "no visible difference, until a caller needs the hits of the whole line"),
    MISTAKE("R-b0", quadratic_roots, nothing_where_b_is_0, "no roots if b = 0",
            "b = 0 says only that the ray starts where it is closest to the centre; the two places "
            "are then on opposite sides.",
            "a sphere that vanishes if the eye is at its centre"),
    {0},
};
