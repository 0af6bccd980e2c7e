// exact.c - the quadratic of a ray and a sphere in whole numbers, by GMP.
#include "tests/proof/exact/exact.h"

#include <float.h>
#include <gmp.h>
#include <math.h>

enum { PRECISION = 1024 };

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

void exact_begin(void)
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

void exact_set(Case c)
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

bool exact_meets(void)
{
    return mpz_sgn(exact.d) >= 0;
}

// The larger root is positive: the roots' sum is, or their product is negative.
bool exact_hits(void)
{
    return exact_meets() && (mpz_sgn(exact.half_b) < 0 || mpz_sgn(exact.c) < 0);
}

// t = (-b / 2 -+ sqrt d) / a
void exact_roots(void)
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

double exact_root(int i)
{
    return mpf_get_d(exact.t[i]);
}

double exact_root_error(double yours, int i)
{
    mpf_set_d(exact.difference, yours);
    mpf_sub(exact.difference, exact.difference, exact.t[i]);
    return fabs(mpf_get_d(exact.difference));
}

// It is d / a.
double exact_r_squared_less_l_squared(void)
{
    signed long d_exponent, a_exponent;
    double d = mpz_get_d_2exp(&d_exponent, exact.d), a = mpz_get_d_2exp(&a_exponent, exact.a);
    return ldexp(d / a, (int)(d_exponent - a_exponent) - 2 * exact.length_shift);
}
