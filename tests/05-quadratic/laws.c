// laws.c - what must hold for a ray, a sphere and their quadratic, whatever the numbers.
//
// Tolerances are wide, so that the slide's plain formula never breaks a law; if numbers are so
// extreme that it loses all digits, the laws are silent.
#include "exercises/05-quadratic.h"

#include "common/text.h"
#include "tests/judge/known.h"

// 0, or of a size whose square stays in range.
static bool tame(double x)
{
    return x == 0 || (fabs(x) > 1e-50 && fabs(x) < 1e50);
}

static bool tame_vec3(vec3 v)
{
    return tame(v[0]) && tame(v[1]) && tame(v[2]);
}

// ---- coefficients -------------------------------------------------------------------------------

LAW(to_object_coordinates)
{
    if (!tame_vec3(ray.origin) || !tame_vec3(ray.direction) || !tame_vec3(sphere.center))
        return;
    double size = vec3_length(ray.origin) + vec3_length(sphere.center);
    double away = vec3_length(right.origin);
    if (!(vec3_length(yours.direction - right.direction) <= 1e-9 * vec3_length(right.direction))) {
        Apart its = apart_vec3(yours.direction, right.direction);
        law_broken("your direction is %s, the given one is %s: a direction is the same seen from "
                   "any point",
                   its.yours.s, its.right.s);
    } else if (!(fabs(vec3_length(yours.origin) - away) <= 1e-9 * size)) {
        Apart its = apart(vec3_length(yours.origin), away);
        law_broken("your origin is %s away from the center, which is now at (0, 0, 0); in the "
                   "world the eye is %s away from it",
                   its.yours.s, its.right.s);
    } else if (!(vec3_length(yours.origin - right.origin) <= 1e-9 * size)) {
        Apart its = apart_vec3(sphere.center + yours.origin, ray.origin);
        law_broken("your origin is as far from the center as it should be, but in another "
                   "direction: center plus origin is %s, and the eye is at %s",
                   its.yours.s, its.right.s);
    }
}

// The eye is so far from the center; size is the size of the arguments. One at a time: only c
// counts at t = 0, then a and b by how they change the parabola.
static void law_of_coefficients(Quadratic yours, Quadratic right, double distance, vec3 v, double r,
                                double size)
{
    double speed = vec3_length(v), tolerance = 1e-9 * (size + speed) * (size + speed);
    if (!tame(distance) || !tame_vec3(v) || !tame(r) || !tame(size) || speed == 0)
        return;
    if (!(fabs(yours.c - right.c) <= tolerance)) {
        Apart its = apart(yours.c, right.c);
        law_broken("at t = 0, where the ray starts, your a t^2 + b t + c is %s; the eye is %s from "
                   "the center and r is %s: the difference of their squares is %s",
                   its.yours.s, number_text(distance).s, number_text(r).s, its.right.s);
    } else if (!(fabs(yours.a - right.a) <= tolerance)) {
        law_broken("with p and r 0 only a t^2 is left, the squared distance from the center: at "
                   "t = 1 yours is %s, but v is %s long, and its square is %s",
                   apart(yours.a, right.a).yours.s, number_text(speed).s,
                   apart(yours.a, right.a).right.s);
    } else if (!(fabs(yours.b - right.b) <= tolerance)) {
        Apart its = apart(-yours.b / (2 * yours.a), -right.b / (2 * right.a));
        law_broken("your a t^2 + b t + c is smallest at t = %s, but the ray is closest to the "
                   "center at t = %s",
                   its.yours.s, its.right.s);
    }
}

LAW(object_quadratic)
{
    double distance = vec3_length(object_ray.origin);
    law_of_coefficients(yours, right, distance, object_ray.direction, radius, distance + radius);
}

LAW(world_quadratic)
{
    law_of_coefficients(yours, right, vec3_length(ray.origin - sphere.center), ray.direction,
                        sphere.radius,
                        vec3_length(ray.origin) + vec3_length(sphere.center) + sphere.radius);
}

// ---- quadratic_roots ----------------------------------------------------------------------------

static const char *const nth[] = {"first", "second"};

static void law_of_a_line(Roots yours, Quadratic q)
{
    if (yours.count != (q.b == 0 ? 0 : 1))
        law_broken("with a = 0 it is a line, and %s; you return count = %d",
                   q.b == 0 ? "with b = 0 as well it is level and never crosses 0"
                            : "this line crosses 0 once",
                   yours.count);
    else if (yours.count == 1 && !(fabs(q.b * yours.t[0] + q.c) <= 1e-9 * fabs(q.c)))
        law_broken("b t + c is %s at your root %s, not 0", number_text(q.b * yours.t[0] + q.c).s,
                   number_text(yours.t[0]).s);
}

static void law_of_a_parabola(Roots yours, Quadratic q)
{
    double d = q.b * q.b - 4 * q.a * q.c, size = q.b * q.b + 4 * fabs(q.a * q.c);
    if (yours.count != 0 && yours.count != 2) {
        law_broken("you return count = %d, but a parabola has 2 roots (which may be equal) or none",
                   yours.count);
        return;
    }
    if (yours.count == 0 && d > 1e-9 * size)
        law_broken("D = b^2 - 4ac is %s, above 0, so there are two roots; you return none",
                   number_text(d).s);
    if (yours.count == 2 && d < -1e-9 * size)
        law_broken("D = b^2 - 4ac is %s, below 0: the parabola never crosses 0, but you return two "
                   "roots",
                   number_text(d).s);
    // 4a (a t^2 + b t + c) is (2at + b)^2 - D; the rounding of D bounds it.
    for (int i = 0; i < yours.count; i++) {
        double t = yours.t[i], value = (q.a * t + q.b) * t + q.c;
        if (!isfinite(t))
            law_broken("your %s root is %s: something was divided by 0, or the square root of a "
                       "negative number was taken",
                       nth[i], number_text(t).s);
        if (!(fabs(4 * q.a * value) <= 1e-9 * size))
            law_broken("a t^2 + b t + c is %s at your %s root, %s, not 0", number_text(value).s,
                       nth[i], number_text(t).s);
    }
    if (yours.count == 2 && yours.t[0] > yours.t[1])
        law_broken("your roots are not ascending: %s comes before %s", number_text(yours.t[0]).s,
                   number_text(yours.t[1]).s);
    if (yours.count == 2 && !(fabs(q.a * (yours.t[0] + yours.t[1]) + q.b) <= 1e-6 * sqrt(size)))
        law_broken("a parabola is symmetric, but your roots %s and %s are around %s, and its "
                   "middle is at %s",
                   number_text(yours.t[0]).s, number_text(yours.t[1]).s,
                   number_text((yours.t[0] + yours.t[1]) / 2).s, number_text(-q.b / (2 * q.a)).s);
}

LAW(quadratic_roots)
{
    if (!tame(q.a) || !tame(q.b) || !tame(q.c))
        return;
    if (q.a == 0)
        law_of_a_line(yours, q);
    else
        law_of_a_parabola(yours, q);
}

// ---- sphere_roots, hit_sphere -------------------------------------------------------------------

// The ray seen from the center, and the point where it comes closest to it.
typedef struct {
    vec3 p, v;
    double r, speed;
    double foot, l;       // t and distance of the closest point
    bool beside, through; // clearly; a ray that only grazes does neither
    bool outside, inside; // is the eye; clearly
} Sight;

// False if the plain formula has too few digits left to be judged: for extreme numbers, and for
// spheres thousands of radii away or far from the world's origin.
static bool look(Ray ray, Sphere sphere, Sight *sight)
{
    vec3 p = ray.origin - sphere.center, v = ray.direction;
    double r = sphere.radius;
    if (!tame_vec3(ray.origin) || !tame_vec3(sphere.center) || !tame_vec3(v) || !tame(r))
        return false;
    double a = vec3_dot(v, v), foot = -vec3_dot(p, v) / a;
    double l = vec3_length(p + foot * v);
    *sight = (Sight){.p = p,
                     .v = v,
                     .r = r,
                     .speed = sqrt(a),
                     .foot = foot,
                     .l = l,
                     .beside = l > r * (1 + 1e-6),
                     .through = l<r *(1 - 1e-6), .outside = vec3_length(p)> r * (1 + 1e-6),
                     .inside = vec3_length(p) < r * (1 - 1e-6)};
    return a > 0 && vec3_length(ray.origin) + vec3_length(sphere.center) < 3000 * r;
}

static double off_the_sphere(const Sight *sight, double t)
{
    return vec3_length(sight->p + t * sight->v) - sight->r;
}

LAW(sphere_roots)
{
    Sight sight;
    if (!look(ray, sphere, &sight))
        return;
    if (yours.count != 0 && yours.count != 2) {
        law_broken("you return count = %d, but a line meets a sphere at 2 points (equal ones if it "
                   "only touches) or at none",
                   yours.count);
        return;
    }
    if (sight.beside && yours.count == 2)
        law_broken("the line passes %s from the center and r is %s: it does not meet the sphere, "
                   "but you return two roots",
                   number_text(sight.l).s, number_text(sight.r).s);
    if (sight.through && yours.count == 0)
        law_broken("the line passes %s from the center and r is %s: it meets the sphere twice, but "
                   "you return no root",
                   number_text(sight.l).s, number_text(sight.r).s);
    for (int i = 0; i < yours.count; i++) {
        double off = off_the_sphere(&sight, yours.t[i]);
        if (!(fabs(off) <= 1e-4 * sight.r))
            law_broken("the point at your %s t = %s is not on the sphere: |p + tv - C| - r = %s",
                       nth[i], number_text(yours.t[i]).s, number_text(off).s);
    }
    if (yours.count == 2 && yours.t[0] > yours.t[1])
        law_broken("your roots are not ascending: t = %s comes before t = %s",
                   number_text(yours.t[0]).s, number_text(yours.t[1]).s);
    double chord = right.t[1] - right.t[0];
    if (sight.through && yours.count == 2 && yours.t[1] - yours.t[0] < chord / 2)
        law_broken("between your two points the ray goes %s, but the chord inside the sphere is %s "
                   "long",
                   number_text((yours.t[1] - yours.t[0]) * sight.speed).s,
                   number_text(chord * sight.speed).s);
}

LAW(hit_sphere)
{
    Sight sight;
    if (!look(ray, sphere, &sight))
        return;
    if (yours == NO_HIT) {
        if (sight.through && right < NO_HIT && right * sight.speed > 1e-6 * sight.r)
            law_broken("the ray %s and passes %s from the center, r is %s: it hits ahead of the "
                       "eye, but you return NO_HIT",
                       sight.inside    ? "starts inside the sphere"
                       : sight.outside ? "comes from outside"
                                       : "starts on the sphere",
                       number_text(sight.l).s, number_text(sight.r).s);
        return;
    }
    if (sight.beside)
        law_broken("the line passes %s from the center and r is %s: it misses, so t is NO_HIT, "
                   "not %s",
                   number_text(sight.l).s, number_text(sight.r).s, number_text(yours).s);
    else if (sight.through && sight.outside && right == NO_HIT)
        law_broken("the whole sphere is behind the eye, so t is NO_HIT, not %s",
                   number_text(yours).s);
    else if (!(yours > 0))
        law_broken("your t = %s is not ahead of the eye, where t > 0", number_text(yours).s);
    else if (!(fabs(off_the_sphere(&sight, yours)) <= 1e-4 * sight.r))
        law_broken("the point at your t = %s is not on the sphere: |p + tv - C| - r = %s",
                   number_text(yours).s, number_text(off_the_sphere(&sight, yours)).s);
    else if (sight.through && sight.outside && yours > sight.foot)
        law_broken(
            "at your t = %s the ray leaves the sphere, but it has entered it ahead of the eye",
            number_text(yours).s);
}
