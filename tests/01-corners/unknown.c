// unknown.c - wrong answers to exercise 01 that are not known mistakes.
#include "tests/proof/unknown.h"

#include "exercises/01-corners.h"

static vec3 down_and_mirrored(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right - c.height / 2 * c.up;
}

static vec3 whole_width_and_no_distance(Camera c)
{
    return c.forward - c.width * c.right + c.height / 2 * c.up;
}

static vec3 rounded_distance(Camera c)
{
    return (int)c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
}

static vec3 the_larger_side(Camera c)
{
    double side = fmax(c.width, c.height);
    return c.distance * c.forward - side / 2 * c.right + side / 2 * c.up;
}

static vec3 the_smaller_side(Camera c)
{
    double side = fmin(c.width, c.height);
    return c.distance * c.forward - side / 2 * c.right + side / 2 * c.up;
}

// 'return d * f - w * 0,5 * r + h * 0,5 * u' returns what follows the last comma.
static vec3 decimal_comma(Camera c)
{
    return 5 * c.up;
}

static vec3 always_zero(Camera c)
{
    (void)c;
    return vec3_of(0, 0, 0);
}

static vec3 just_forward(Camera c)
{
    return c.forward;
}

static vec3 across_a_third(Camera c)
{
    return c.distance * c.forward + (0.33 - 0.5) * c.width * c.right +
           (0.1 - 0.5) * c.height * c.up;
}

static vec3 growing(Camera c)
{
    static int calls;
    return ++calls * c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
}

static vec3 place_turned_and_doubled(Camera c, double s, double t)
{
    return c.distance * c.forward + (0.5 - s) * c.width * c.right + 2 * (t - 0.5) * c.height * c.up;
}

static const Unknown unknowns[] = {
    UNKNOWN(upper_left, rounded_distance, NOBODY, "(int)d"),
    UNKNOWN(upper_left, the_larger_side, NOBODY, "the larger side for both"),
    UNKNOWN(upper_left, the_smaller_side, NOBODY, "the smaller side for both"),
    UNKNOWN(upper_left, decimal_comma, NOBODY, "0,5 for 0.5"),
    UNKNOWN(upper_left, always_zero, NOBODY " your function returns the same", "always 0"),
    UNKNOWN(upper_left, just_forward, NOBODY " your function returns one of its arguments", "f"),
    UNKNOWN(upper_left, growing, NOBODY " your function gives another result", "a counter"),
    UNKNOWN(upper_left, down_and_mirrored, "C2-C3", "both signs"),
    UNKNOWN(upper_left, whole_width_and_no_distance, "C1-w and C4", "w, and no d"),
    UNKNOWN(across_30_up_10, across_a_third, NOBODY, "a third"),
    UNKNOWN(image_plane_vector, place_turned_and_doubled, NOBODY, "s mirrored, and h twice"),
    {0},
};
OF_STEM(unknowns)
