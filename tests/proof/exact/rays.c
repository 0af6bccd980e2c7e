// rays.c - random rays and spheres, by families.
#include "tests/proof/exact/rays.h"

#include <float.h>
#include <stdint.h>

enum { WIDEST_ULPS = 40 };

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

Case (*const families[FAMILIES])(void) = {ordinary, tangent, nearly_tangent, far,
                                          tiny,     inside,  any_length,     behind};
const char *const family_names[FAMILIES] = {"ordinary", "tangent", "nearly tangent", "far",
                                            "tiny",     "inside",  "any length",     "behind"};
