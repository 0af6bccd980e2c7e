// mistakes-digits.c - answers that are right except for their last digits.
//
// Only the extra tests, which cost no marks, can distinguish them from right ones; hence the X in
// front.
#include "tests/05-quadratic/mistakes.h"

// The stable sum, but without care for the discriminant or the range.
static Roots only_the_sum(Quadratic q)
{
    double d = discriminant(q), sum = -(q.b + copysign(sqrt(d), q.b)) / 2;
    if (q.a == 0 || d < 0)
        return slide(q);
    return sum == 0 ? (Roots){2, {0, 0}} : in_order(sum / q.a, q.c / sum);
}

static Roots stable_roots_of_the_slide(Ray ray, Sphere s)
{
    return quadratic_roots(object_quadratic(to_object_coordinates(ray, s), s.radius));
}

// Measured from the foot of the perpendicular, but squares leave the range of a double.
static Roots foot_without_scale(Ray ray, Sphere s)
{
    vec3 p = ray.origin - s.center, v = ray.direction;
    double foot = -vec3_dot(p, v) / vec3_dot(v, v), l = vec3_length(p + foot * v);
    if (!(l <= s.radius))
        return no_roots;
    double half = sqrt((s.radius - l) * (s.radius + l)) / vec3_length(v);
    return (Roots){2, {foot - half, foot + half}};
}

const Mistake digit_mistakes[] = {
    MISTAKE(
        "X-slide", quadratic_roots, slide, "t = (-b +- sqrt(D)) / (2a)",
        "right, and good enough for full marks. If -b and sqrt(D) nearly cancel, digits are lost.",
        "no visible difference, except for small spheres very far away"),
    MISTAKE("X-sum", quadratic_roots, only_the_sum, "q/a and c/q, with the sign of b",
            "right, and nothing cancels in q. But digits still cancel in D = b^2 - 4ac, and it "
            "overflows for large numbers.",
            "no visible difference, except for small spheres very far away"),
    MISTAKE("X-sphere", sphere_roots, slide_for_spheres, "the roots of a, b, c by the slide",
            "right, and good enough for full marks. Far from a small sphere, r^2 loses its "
            "digits beside p.p, and then again in D.",
            "speckled or missing spheres, a million radii away"),
    MISTAKE("X-stable", sphere_roots, stable_roots_of_the_slide,
            "stable roots of the slide's a, b, c",
            "right, and the roots are as careful as possible. But they cannot recover the digits "
            "that c = p.p - r^2 has lost.",
            "speckled or missing spheres, ten million radii away"),
    MISTAKE("X-scale", sphere_roots, foot_without_scale, "t = -p.v / v.v +- sqrt(r^2 - l^2) / |v|",
            "right, and good for distant spheres. But squares of the largest and smallest numbers "
            "leave the range of a double.",
            "no visible difference in any scene that can be drawn"),
    {0},
};
