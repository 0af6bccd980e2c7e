// mistakes-limits.c - right in part: answers with a limit of their own, for the sizes that their
// authors thought of (a length is neither small nor large in itself, only compared with another
// one); and those that forget one of three components.
#include "tests/05-quadratic/mistakes.h"

// ---- quadratic_roots ----------------------------------------------------------------------------

static const double tiny = 1e-6;

static Roots small_a_taken_for_0(Quadratic q)
{
    return fabs(q.a) < tiny ? line_root(q) : slide(q);
}

static Roots small_b_taken_for_0(Quadratic q)
{
    return q.a == 0 && fabs(q.b) < tiny ? no_roots : slide(q);
}

static Roots small_discriminant_taken_for_0(Quadratic q)
{
    double middle = -q.b / (2 * q.a);
    return q.a != 0 && fabs(discriminant(q)) < tiny ? (Roots){2, {middle, middle}} : slide(q);
}

static Roots small_discriminant_lost(Quadratic q)
{
    return q.a != 0 && discriminant(q) < tiny ? no_roots : slide(q);
}

static Roots in_float(Quadratic q)
{
    float a = (float)q.a, b = (float)q.b, c = (float)q.c;
    if (a == 0)
        return b == 0 ? no_roots : (Roots){1, {-c / b}};
    float d = b * b - 4 * a * c, root = sqrtf(d);
    return d < 0 ? no_roots : in_order((-b - root) / (2 * a), (-b + root) / (2 * a));
}

// ---- sphere_roots, hit_sphere -------------------------------------------------------------------

static Roots nothing_shorter_than_a_millionth(Ray ray, Sphere s)
{
    Roots roots = slide_for_spheres(ray, s);
    return roots.count == 2 && !(roots.t[1] - roots.t[0] > tiny) ? no_roots : roots;
}

static double first_root_between(Ray ray, Sphere s, double least, double most)
{
    Roots roots = slide_for_spheres(ray, s);
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > least && roots.t[i] < most)
            return roots.t[i];
    return NO_HIT;
}

static double epsilon_of_a_millionth(Ray ray, Sphere s)
{
    return first_root_between(ray, s, 1e-6, NO_HIT);
}

static double epsilon_of_a_billionth(Ray ray, Sphere s)
{
    return first_root_between(ray, s, 1e-9, NO_HIT);
}

static double at_most_a_thousand(Ray ray, Sphere s)
{
    return first_root_between(ray, s, 0, 1000);
}

static double at_most_a_million(Ray ray, Sphere s)
{
    return first_root_between(ray, s, 0, 1e6);
}

static double hit_in_float(Ray ray, Sphere s)
{
    Roots roots = in_float(object_quadratic(to_object_coordinates(ray, s), s.radius));
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > 0)
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

static Quadratic world_equation_in_float(Ray ray, Sphere s)
{
    return equation_in_float(to_object_coordinates(ray, s), s.radius);
}

static Quadratic a_at_least_a_millionth(Ray ray, double radius)
{
    Quadratic q = object_quadratic(ray, radius);
    q.a = fmax(q.a, tiny);
    return q;
}

// ---- two of three components --------------------------------------------------------------------

static Ray z_not_moved(Ray ray, Sphere s)
{
    s.center[2] = 0;
    return (Ray){ray.origin - s.center, ray.direction};
}

// Sums of two products instead of three: the result is a circle in the plane of x and y.
static vec3 without_z(vec3 v)
{
    return vec3_of(v[0], v[1], 0);
}

static Quadratic z_left_out(Ray ray, double radius)
{
    return object_quadratic((Ray){without_z(ray.origin), without_z(ray.direction)}, radius);
}

static Quadratic z_left_out_of_a(Ray ray, double radius)
{
    Quadratic q = object_quadratic(ray, radius);
    q.a = z_left_out(ray, radius).a;
    return q;
}

static Quadratic z_left_out_of_b(Ray ray, double radius)
{
    Quadratic q = object_quadratic(ray, radius);
    q.b = z_left_out(ray, radius).b;
    return q;
}

static Quadratic z_left_out_of_c(Ray ray, double radius)
{
    Quadratic q = object_quadratic(ray, radius);
    q.c = z_left_out(ray, radius).c;
    return q;
}

static Quadratic z_left_out_of_the_world(Ray ray, Sphere s)
{
    return z_left_out(to_object_coordinates(ray, s), s.radius);
}

#define TWO_OF_THREE                                                                               \
    "a dot product is the sum of three products, and the product of the z components is missing."
#define SEVEN_DIGITS "a float has 7 digits, and squares and differences use them up. Use double."

const Mistake root_limit_mistakes[] = {
    MISTAKE("R-a-tiny", quadratic_roots, small_a_taken_for_0, "a line if |a| < 1e-6",
            "with a short direction a is small, but the parabola still bends. It is a line only if "
            "a is 0.",
            "whole scenes lost if they are large and the directions short"),
    MISTAKE("R-b-tiny", quadratic_roots, small_b_taken_for_0, "no root if a = 0 and |b| < 1e-6",
            "a line that rises slowly still crosses 0, only farther away.",
            "no visible difference, because for a ray and a sphere a is never 0"),
    MISTAKE("R-D-tiny", quadratic_roots, small_discriminant_taken_for_0, "one place if |D| < 1e-6",
            "the size of D depends on the size of a, b and c. For a small sphere or a short "
            "direction D is always small.",
            "small spheres drawn as flat discs, and too large"),
    MISTAKE("R5-tiny", quadratic_roots, small_discriminant_lost, "roots only if D > 1e-6",
            "the size of D depends on the size of a, b and c. For a small sphere or a short "
            "direction D is always small.",
            "small spheres vanish"),
    MISTAKE("R-float", quadratic_roots, in_float, "the formula in float", SEVEN_DIGITS,
            "speckles, and ragged edges"),
    MISTAKE("S-tiny", sphere_roots, nothing_shorter_than_a_millionth,
            "nothing if t[1] - t[0] is below 1e-6",
            "with a long direction the whole sphere is that short in t.",
            "spheres vanish if the directions are long"),
    MISTAKE("R10-micro", hit_sphere, epsilon_of_a_millionth, "only t > 0.000001",
            "rays that start on a surface need such a limit; these start at the eye. And t counts "
            "in lengths of v: with a long v the whole scene is nearer than that.",
            "spheres vanish if the directions are long"),
    MISTAKE("R10-nano", hit_sphere, epsilon_of_a_billionth, "only t > 0.000000001",
            "rays that start on a surface need such a limit; these start at the eye. And t counts "
            "in lengths of v: with a long v the whole scene is nearer than that.",
            "no visible difference, until the directions are very long"),
    MISTAKE("T-limit", hit_sphere, at_most_a_thousand, "only t < 1000",
            "the eye sees at any distance: t counts in lengths of v, and with a short v everything "
            "is farther than that.",
            "distant spheres vanish"),
    MISTAKE("T-limit-far", hit_sphere, at_most_a_million, "only t < 1000000",
            "the eye sees at any distance: t counts in lengths of v, and with a short v everything "
            "is farther than that.",
            "very distant spheres vanish"),
    MISTAKE("T-float", hit_sphere, hit_in_float, "the formula in float", SEVEN_DIGITS,
            "speckles, and ragged edges"),
    MISTAKE("Q-float", object_quadratic, equation_in_float, "a, b, c in float", SEVEN_DIGITS,
            "speckles, and ragged edges"),
    MISTAKE("Q-float-world", world_quadratic, world_equation_in_float, "a, b, c in float",
            SEVEN_DIGITS, "speckles, and ragged edges"),
    MISTAKE("Q5-tiny", object_quadratic, a_at_least_a_millionth, "a at least 1e-6",
            "a is 0 only for a v of length 0, which no ray has. For a short v it is small.",
            "spheres out of shape if the directions are short"),
    MISTAKE("O-z", to_object_coordinates, z_not_moved, "z unchanged",
            "x and y are seen from the centre of the sphere, but z is not. A vector has three "
            "components.",
            "spheres moved along z to the origin of the world"),
    MISTAKE("Q-z", object_quadratic, z_left_out, "x and y only", TWO_OF_THREE,
            "endless tubes instead of spheres"),
    MISTAKE("Q-z-a", object_quadratic, z_left_out_of_a, "a = v_x^2 + v_y^2", TWO_OF_THREE,
            "distorted spheres, or none"),
    MISTAKE("Q-z-b", object_quadratic, z_left_out_of_b, "b = 2 (p_x v_x + p_y v_y)", TWO_OF_THREE,
            "distorted spheres, or none"),
    MISTAKE("Q-z-c", object_quadratic, z_left_out_of_c, "c = p_x^2 + p_y^2 - r^2", TWO_OF_THREE,
            "distorted spheres, or none"),
    MISTAKE("Q-z-world", world_quadratic, z_left_out_of_the_world, "x and y only", TWO_OF_THREE,
            "endless tubes instead of spheres"),
    {0},
};
