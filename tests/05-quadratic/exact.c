// exact.c - exercise 05 with roots that keep all their digits, for the judge, the programs and the
// engines: no difference of nearly equal numbers, and for the sphere a discriminant computed at the
// point of the ray that is closest to the center. solutions/05-quadratic.c has the slide's
// formulas; they pass all graded tests, but not the extra ones about digits. 'Losing digits' in the
// lesson.
#include "exercises/05-quadratic.h"

Ray to_object_coordinates(Ray ray, Sphere sphere)
{
    return (Ray){ray.origin - sphere.center, ray.direction};
}

Quadratic object_quadratic(Ray object_ray, double radius)
{
    vec3 p = object_ray.origin, v = object_ray.direction;
    return (Quadratic){vec3_dot(v, v), 2 * vec3_dot(p, v), vec3_dot(p, p) - radius * radius};
}

Quadratic world_quadratic(Ray ray, Sphere sphere)
{
    vec3 p = ray.origin, v = ray.direction, c = sphere.center;
    return (Quadratic){vec3_dot(v, v), 2 * (vec3_dot(p, v) - vec3_dot(c, v)),
                       vec3_dot(p, p) - 2 * vec3_dot(p, c) + vec3_dot(c, c) -
                           sphere.radius * sphere.radius};
}

static int exponent(double x)
{
    int e = 0;
    frexp(x, &e);
    return e;
}

static Roots ascending(double t, double u)
{
    return t <= u ? (Roots){2, {t, u}} : (Roots){2, {u, t}};
}

// b^2 - 4ac, exact almost to its last digit: fma gives the part of 4ac that rounding lost (Kahan,
// 'On the Cost of Floating-Point Computation Without Extra-Precise Arithmetic').
static double discriminant(Quadratic q)
{
    double product = 4 * q.a * q.c;
    double lost = fma(-4 * q.a, q.c, product);
    return fma(q.b, q.b, -product) + lost;
}

// Substitutes t = 2^k u and multiplies all three coefficients by a power of two, so that nothing
// overflows and b^2 and 4ac have similar sizes. Powers of two lose no digits.
static Quadratic balanced(Quadratic q, int *k)
{
    *k = q.c == 0 ? exponent(q.b) - exponent(q.a) : (exponent(q.c) - exponent(q.a)) / 2;
    int a = exponent(q.a) + 2 * *k, b = exponent(q.b) + *k, c = exponent(q.c);
    int largest = a;
    if (q.b != 0 && b > largest)
        largest = b;
    if (q.c != 0 && c > largest)
        largest = c;
    return (Quadratic){ldexp(q.a, 2 * *k - largest), ldexp(q.b, *k - largest),
                       ldexp(q.c, -largest)};
}

Roots quadratic_roots(Quadratic q)
{
    if (!isfinite(q.a) || !isfinite(q.b) || !isfinite(q.c))
        return (Roots){0};
    if (q.a == 0)
        return q.b == 0 ? (Roots){0} : (Roots){1, {-q.c / q.b}};

    // If b^2 is much larger than 4ac, the square root is b to the last digit.
    if (q.b != 0 && 2 * exponent(q.b) - exponent(q.a) - exponent(q.c) > 200)
        return ascending(-q.b / q.a, -q.c / q.b);

    int k;
    Quadratic even = balanced(q, &k);
    double d = discriminant(even);
    if (d < 0)
        return (Roots){0};
    // -b and the square root get the same sign, so that they add up and no digit is lost. The
    // other root follows from the product of both roots, c / a.
    double sum = -(even.b + copysign(sqrt(d), even.b)) / 2;
    if (sum == 0)
        return (Roots){2, {0, 0}};
    return ascending(ldexp(sum / even.a, k), ldexp(even.c / sum, k));
}

// Where the line p + tv meets a sphere of radius r around the origin. The line is closest to the
// center at t = -p.v / v.v. Its distance is l there, so half the chord is sqrt(r^2 - l^2) long.
// Written as (r - l)(r + l), no digits cancel, however far away p is.
static Roots roots_near_origin(vec3 p, vec3 v, double r)
{
    double a = vec3_dot(v, v);
    double half_b = vec3_dot(p, v);
    vec3 closest = p - half_b / a * v;
    double l_squared = vec3_dot(closest, closest);
    if (!(l_squared <= r * r))
        return (Roots){0};
    double l = fmin(sqrt(l_squared), r); // squares of the smallest numbers lose digits
    double distance = vec3_length(p);
    double c = (distance - r) * (distance + r);
    double sum = -(half_b + copysign(sqrt(a * (r - l) * (r + l)), half_b));
    if (sum == 0)
        return (Roots){2, {0, 0}};
    return ascending(sum / a, c / sum);
}

static double largest(vec3 v)
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

static bool squares_well(double x)
{
    return x > 0x1p-400 && x < 0x1p400;
}

// The same, after powers of two have scaled all numbers to about 1.
static Roots roots_when_extreme(Ray ray, Sphere sphere)
{
    vec3 o = ray.origin, c = sphere.center, v = ray.direction;
    if (!vec3_is_finite(o) || !vec3_is_finite(c) || !vec3_is_finite(v) || largest(v) == 0)
        return (Roots){0};
    int speed = exponent(largest(v));
    v = vec3_of(ldexp(v[0], -speed), ldexp(v[1], -speed), ldexp(v[2], -speed));

    // Halved first, because o - c may overflow.
    vec3 p = o / 2 - c / 2;
    double r = sphere.radius / 2;
    int size = exponent(fmax(largest(p), r));
    p = vec3_of(ldexp(p[0], -size), ldexp(p[1], -size), ldexp(p[2], -size));
    Roots roots = roots_near_origin(p, v, ldexp(r, -size));
    for (int i = 0; i < roots.count; i++)
        roots.t[i] = ldexp(roots.t[i], size + 1 - speed);
    return roots;
}

Roots sphere_roots(Ray ray, Sphere sphere)
{
    vec3 p = ray.origin - sphere.center;
    if (!squares_well(vec3_dot(ray.direction, ray.direction)) ||
        !squares_well(vec3_dot(p, p) + sphere.radius * sphere.radius))
        return roots_when_extreme(ray, sphere);
    return roots_near_origin(p, ray.direction, sphere.radius);
}

double hit_sphere(Ray ray, Sphere sphere)
{
    Roots roots = sphere_roots(ray, sphere);
    for (int i = 0; i < roots.count; i++)
        if (roots.t[i] > 0)
            return roots.t[i];
    return NO_HIT;
}
