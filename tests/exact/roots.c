// roots.c - the reference against exact arithmetic: a million random rays and spheres.
//
// Doubles are whole numbers times a power of two, so GMP computes the discriminant without any
// error. The claim: the reference never disagrees on whether the line meets the sphere, nor on
// whether the ray hits it, except where |l - r| <= k eps |o - c|. l is the distance of the line
// from the centre c, r the radius, o the ray's origin. Both roots are compared too.
#include "exercises/05-quadratic.h"

#include <float.h>
#include <gmp.h>
#include <stdint.h>
#include <stdio.h>
#include <unistd.h>

// Rounding moves l by at most 2.1 eps |o - c| to first order: 1/2 by o - c, 1/2 by what is taken
// from it to reach the foot of the perpendicular, 3/2 by the rest; and by 3.6 where l is next to 0.
static const double doubtful_k = 4;

// A root moves by d r / h where the centre moves by d; h is half the chord. So this is how far, in
// eps (|o - c| + r), the sphere would have to move to excuse the error of a root: the roundings of
// a, b and the two roots.
static const double most_error = 8;

enum { RAYS = 1000000, PRECISION = 1024, WIDEST_ULPS = 40 };

// ---- random rays --------------------------------------------------------------------------------

// SplitMix64.
static uint64_t random_bits(void)
{
    static uint64_t state = 2015;
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static double uniform(double low, double high)
{
    return low + (high - low) * (double)(random_bits() >> 11) * 0x1p-53;
}

static int whole(int low, int high)
{
    return low + (int)(random_bits() % (uint64_t)(high - low + 1));
}

static double power_of_ten(double low, double high)
{
    return pow(10, uniform(low, high));
}

static vec3 in_unit_ball(void)
{
    for (;;) {
        double x = uniform(-1, 1), y = uniform(-1, 1);
        vec3 v = vec3_of(x, y, uniform(-1, 1));
        if (vec3_dot(v, v) <= 1)
            return v;
    }
}

static vec3 unit(void)
{
    for (;;) {
        vec3 v = in_unit_ball();
        if (vec3_length(v) > 0.1)
            return vec3_unit(v);
    }
}

typedef struct {
    Ray ray;
    Sphere sphere;
} Case;

// A sphere some radii away; the ray is aimed at it or a little beside it.
static Case aimed(double radius, double radii)
{
    Case c = {.sphere = {.center = radius * 10 * in_unit_ball(), .radius = radius}};
    c.ray.origin = c.sphere.center + radii * radius * unit();
    vec3 target = c.sphere.center + 1.3 * radius * in_unit_ball();
    c.ray.direction = vec3_unit(target - c.ray.origin);
    return c;
}

// The same, between 1.1 and 10^power radii away.
static Case aimed_from_within(double radius, double power)
{
    return aimed(radius, power_of_ten(0.05, power));
}

static Case ordinary(void)
{
    return aimed_from_within(uniform(0.1, 3), 2);
}

static Case far(void)
{
    double radii = power_of_ten(2, 9);
    return aimed(uniform(0.1, 3), radii);
}

static Case tiny(void)
{
    return aimed_from_within(power_of_ten(-12, -3), 6);
}

static Case inside(void)
{
    Case c = aimed(power_of_ten(-3, 3), 2);
    c.ray.origin = c.sphere.center + 0.999 * c.sphere.radius * in_unit_ball();
    c.ray.direction = unit();
    return c;
}

static Case any_length(void)
{
    Case c = aimed_from_within(uniform(0.1, 3), 4);
    c.ray.direction = c.ray.direction * power_of_ten(-6, 6);
    return c;
}

static Case behind(void)
{
    Case c = aimed_from_within(uniform(0.1, 3), 6);
    c.ray.direction = -c.ray.direction;
    return c;
}

// The columns of this matrix are at right angles, and all as long as the sum of the four squares
// (Euler's rotation matrix in whole numbers).
static int whole_frame(vec3 columns[3])
{
    int a = whole(1, 9), b = whole(-9, 9), c = whole(-9, 9), d = whole(-9, 9);
    columns[0] = vec3_of(a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c));
    columns[1] = vec3_of(2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b));
    columns[2] = vec3_of(2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d);
    return a * a + b * b + c * c + d * d;
}

// Whole numbers times a power of two, so exactly tangent.
static Case tangent(void)
{
    vec3 frame[3];
    int length = whole_frame(frame);
    int aside = 1 << whole(0, 16), ahead = whole(-9, 1 << 30), turns = whole(1, 9);
    double size = ldexp(1, whole(-30, 30)), speed = ldexp(turns, whole(-20, 20));
    vec3 origin = (double)whole(-9999, 9999) * vec3_of(1, -7, 3);
    vec3 center = origin + ahead * frame[0] + 3 * aside * frame[1] + 4 * aside * frame[2];
    return (Case){{size * origin, speed * frame[0]},
                  {.center = size * center, .radius = size * 5 * aside * length}};
}

// A tangent ray whose radius is off by some units in the last place, of its own or of |o - c|.
static Case nearly_tangent(void)
{
    if (whole(0, 1) == 0) {
        Case c = tangent();
        c.sphere.radius *= 1 + whole(-WIDEST_ULPS, WIDEST_ULPS) * DBL_EPSILON;
        return c;
    }
    Case c = aimed_from_within(uniform(0.1, 3), 9);
    vec3 p = c.ray.origin - c.sphere.center, v = c.ray.direction;
    double l = vec3_length(vec3_cross(p, v)) / vec3_length(v);
    c.sphere.radius =
        fabs(l + uniform(-WIDEST_ULPS, WIDEST_ULPS) / 4 * DBL_EPSILON * vec3_length(p));
    return c;
}

static Case (*const families[])(void) = {ordinary, tangent, nearly_tangent, far,
                                         tiny,     inside,  any_length,     behind};
static const char *const family_names[] = {"ordinary", "tangent", "nearly tangent", "far",
                                           "tiny",     "inside",  "any length",     "behind"};
enum { FAMILIES = sizeof families / sizeof families[0] };

// ---- exact --------------------------------------------------------------------------------------

// x = n 2^exponent with a whole n of 53 bits.
static int exponent(double x)
{
    int e;
    frexp(x, &e);
    return e - DBL_MANT_DIG;
}

// x 2^shift, which must be whole.
static void set_whole(mpz_t n, double x, int shift)
{
    int e;
    double fraction = frexp(x, &e);
    mpz_set_d(n, ldexp(fraction, DBL_MANT_DIG));
    e += shift - DBL_MANT_DIG;
    if (x != 0 && e > 0)
        mpz_mul_2exp(n, n, (mp_bitcnt_t)e);
}

// The quadratic as whole numbers; d is (b / 2)^2 - a c. Lengths are times 2^length_shift, the
// direction is times 2^speed_shift.
static struct {
    mpz_t p[3], v[3], term, half_b, a, c, d;
    mpf_t root_of_d, t[2], difference;
    int length_shift, speed_shift;
} exact;

static void exact_begin(void)
{
    mpf_set_default_prec(PRECISION);
    for (int i = 0; i < 3; i++)
        mpz_inits(exact.p[i], exact.v[i], (mpz_ptr)NULL);
    mpz_inits(exact.term, exact.half_b, exact.a, exact.c, exact.d, (mpz_ptr)NULL);
    mpf_inits(exact.root_of_d, exact.t[0], exact.t[1], exact.difference, (mpf_ptr)NULL);
}

static void set_dot(mpz_t n, mpz_t v[3], mpz_t w[3])
{
    mpz_mul(n, v[0], w[0]);
    mpz_addmul(n, v[1], w[1]);
    mpz_addmul(n, v[2], w[2]);
}

static int at_least(int shift, double x)
{
    return x != 0 && -exponent(x) > shift ? -exponent(x) : shift;
}

static void exact_set(Case c)
{
    exact.length_shift = at_least(0, c.sphere.radius);
    exact.speed_shift = 0;
    for (int i = 0; i < 3; i++) {
        exact.length_shift = at_least(exact.length_shift, c.ray.origin[i]);
        exact.length_shift = at_least(exact.length_shift, c.sphere.center[i]);
        exact.speed_shift = at_least(exact.speed_shift, c.ray.direction[i]);
    }
    for (int i = 0; i < 3; i++) {
        set_whole(exact.p[i], c.ray.origin[i], exact.length_shift);
        set_whole(exact.term, c.sphere.center[i], exact.length_shift);
        mpz_sub(exact.p[i], exact.p[i], exact.term);
        set_whole(exact.v[i], c.ray.direction[i], exact.speed_shift);
    }
    set_dot(exact.a, exact.v, exact.v);
    set_dot(exact.half_b, exact.p, exact.v);
    set_dot(exact.c, exact.p, exact.p);
    set_whole(exact.term, c.sphere.radius, exact.length_shift);
    mpz_submul(exact.c, exact.term, exact.term);
    mpz_mul(exact.d, exact.half_b, exact.half_b);
    mpz_submul(exact.d, exact.a, exact.c);
}

static bool exact_meets(void)
{
    return mpz_sgn(exact.d) >= 0;
}

// The larger root is positive: the roots' sum is, or their product is negative.
static bool exact_hits(void)
{
    return exact_meets() && (mpz_sgn(exact.half_b) < 0 || mpz_sgn(exact.c) < 0);
}

// t = (-b / 2 -+ sqrt d) / a
static void exact_roots(void)
{
    mpf_set_z(exact.root_of_d, exact.d);
    mpf_sqrt(exact.root_of_d, exact.root_of_d);
    mpf_set_z(exact.difference, exact.half_b);
    mpf_neg(exact.difference, exact.difference);
    mpf_sub(exact.t[0], exact.difference, exact.root_of_d);
    mpf_add(exact.t[1], exact.difference, exact.root_of_d);
    mpf_set_z(exact.difference, exact.a);
    int shift = exact.speed_shift - exact.length_shift;
    for (int i = 0; i < 2; i++) {
        mpf_div(exact.t[i], exact.t[i], exact.difference);
        if (shift >= 0)
            mpf_mul_2exp(exact.t[i], exact.t[i], (mp_bitcnt_t)shift);
        else
            mpf_div_2exp(exact.t[i], exact.t[i], (mp_bitcnt_t)-shift);
    }
}

// r^2 - l^2, which is d / a.
static double r_squared_less_l_squared(void)
{
    signed long d_exponent, a_exponent;
    double d = mpz_get_d_2exp(&d_exponent, exact.d), a = mpz_get_d_2exp(&a_exponent, exact.a);
    return ldexp(d / a, (int)(d_exponent - a_exponent) - 2 * exact.length_shift);
}

// ---- comparing ----------------------------------------------------------------------------------

typedef struct {
    long rays, doubtful, disagreed, failed;
    double widest; // |l - r| / (eps |o - c|), of those that disagreed
    double error;  // of a root, in eps (|o - c| + r) r / h, outside the doubtful band
    double digits; // the same error relative to the root itself
} Found;

// How far one root is from the exact t[i].
static double root_error(double yours, int i)
{
    mpf_set_d(exact.difference, yours);
    mpf_sub(exact.difference, exact.difference, exact.t[i]);
    return fabs(mpf_get_d(exact.difference));
}

static bool roots_are_good(Case c, Roots roots, double hit, double half_chord, Found *found)
{
    exact_roots();
    double away = vec3_length(c.ray.origin - c.sphere.center), r = c.sphere.radius;
    double speed = vec3_length(c.ray.direction);
    double unit_of_error = DBL_EPSILON * (away + r) * r / half_chord / speed;
    double worst = 0;
    for (int i = 0; i < 2; i++) {
        double error = root_error(roots.t[i], i);
        worst = fmax(worst, error / unit_of_error);
        found->digits = fmax(found->digits, error / fabs(mpf_get_d(exact.t[i])));
    }
    if (exact_hits())
        worst = fmax(worst, root_error(hit, mpf_sgn(exact.t[0]) > 0 ? 0 : 1) / unit_of_error);
    found->error = fmax(found->error, worst);
    return worst <= most_error;
}

static void show(const char *what, Case c)
{
    printf("not ok: %s: origin (%a, %a, %a), direction (%a, %a, %a), center (%a, %a, %a), "
           "radius %a\n",
           what, c.ray.origin[0], c.ray.origin[1], c.ray.origin[2], c.ray.direction[0],
           c.ray.direction[1], c.ray.direction[2], c.sphere.center[0], c.sphere.center[1],
           c.sphere.center[2], c.sphere.radius);
}

static void compare(Case c, Found *found)
{
    enum { MOST_SHOWN = 5 };
    exact_set(c);
    Roots roots = sphere_roots(c.ray, c.sphere);
    double hit = hit_sphere(c.ray, c.sphere);

    double r = c.sphere.radius, chord = r_squared_less_l_squared();
    double l = sqrt(fmax(0, r * r - chord));
    double away = vec3_length(c.ray.origin - c.sphere.center);
    double off = fabs(chord) / (l + r) / (DBL_EPSILON * away); // |l - r| in eps |o - c|
    bool doubtful = off <= doubtful_k;
    bool agree = roots.count == (exact_meets() ? 2 : 0) && (hit < NO_HIT) == exact_hits();
    bool good = agree || doubtful;
    const char *what = "hit or miss";
    if (exact_meets() && !doubtful && agree) {
        good = roots_are_good(c, roots, hit, sqrt(chord), found);
        what = "the roots";
    }

    found->rays++;
    found->doubtful += doubtful;
    if (!agree) {
        found->disagreed++;
        found->widest = fmax(found->widest, off);
    }
    if (!good && found->failed++ < MOST_SHOWN)
        show(what, c);
}

static void print_found(const char *name, const Found *f)
{
    printf("%-15s %8ld %9ld %10ld %8.2f %12.2f %12.1e\n", name, f->rays, f->doubtful, f->disagreed,
           f->widest, f->error, f->digits);
}

int main(void)
{
    bool talks = isatty(STDERR_FILENO) == 1;
    Found all = {0};
    int failed_families = 0;
    exact_begin();
    printf("Doubtful where |l - r| <= %g eps |o - c|; roots within %g eps (|o - c| + r) r / h.\n\n",
           doubtful_k, most_error);
    printf("%-15s %8s %9s %10s %8s %12s %12s\n", "rays", "number", "doubtful", "disagreed",
           "widest", "root error", "relative");
    for (int family = 0; family < FAMILIES; family++) {
        Found found = {0};
        for (int i = 0; i < RAYS / FAMILIES; i++) {
            compare(families[family](), &found);
            if (talks && i % 4096 == 0)
                fprintf(stderr, "\r%d%% ", (int)((all.rays + i) * 100 / RAYS));
        }
        if (talks)
            fprintf(stderr, "\r     \r");
        print_found(family_names[family], &found);
        all.rays += found.rays;
        all.doubtful += found.doubtful;
        all.disagreed += found.disagreed;
        failed_families += found.failed > 0;
        all.widest = fmax(all.widest, found.widest);
        all.error = fmax(all.error, found.error);
        all.digits = fmax(all.digits, found.digits);
    }
    print_found("all", &all);
    printf("exact: %d passed, %d failed\n", FAMILIES - failed_families, failed_families);
    return failed_families == 0 ? 0 : 1;
}
