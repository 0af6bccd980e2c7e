// mistakes-limits.c - right for some cameras, or for two of the three axes: conditions and limits
// that their authors added, and a forgotten last component.
#include "tests/01-corners/mistakes.h"

static vec3 rounded_to_float(vec3 v)
{
    return vec3_of((float)v[0], (float)v[1], (float)v[2]);
}

static vec3 without_z(vec3 v)
{
    return vec3_of(v[0], v[1], 0);
}

static vec3 corner(Camera c, double side)
{
    return side < 0 ? upper_left(c) : upper_right(c);
}

static vec3 in_float(Camera c, double side)
{
    return rounded_to_float(corner(c, side));
}

static vec3 only_x_and_y(Camera c, double side)
{
    return without_z(corner(c, side));
}

ON_BOTH_SIDES(in_float)
ON_BOTH_SIDES(only_x_and_y)

static vec3 place_in_float(Camera c, double s, double t)
{
    return rounded_to_float(image_plane_vector(c, s, t));
}

static vec3 place_only_x_and_y(Camera c, double s, double t)
{
    return without_z(image_plane_vector(c, s, t));
}

static vec3 across_in_float(Camera c)
{
    return rounded_to_float(image_plane_vector(c, 0.3, 0.1));
}

static Camera only_where_the_plane_is_far(Camera c)
{
    return c.distance > 1 ? with_unit_distance(c) : c;
}

static Camera only_where_the_plane_is_near(Camera c)
{
    return c.distance < 1 ? with_unit_distance(c) : c;
}

#define SEVEN_DIGITS "a float has 7 digits, and the answer needs 9. Use double."

const Mistake place_limit_mistakes[] = {
    SIDES("C-float", in_float, "the formula in float", "the formula in float", SEVEN_DIGITS,
          "no visible difference, or ragged edges"),
    SIDES("C-z", only_x_and_y, "x and y right, z = 0", "x and y right, z = 0",
          "a vector has three components, [0], [1] and [2]. The last one is missing.",
          "blank, or a picture from the wrong side"),
    MISTAKE("C6-float", across_30_up_10, across_in_float, "the formula in float", SEVEN_DIGITS,
            "no visible difference, or ragged edges"),
    MISTAKE("G-float", image_plane_vector, place_in_float, "the formula in float", SEVEN_DIGITS,
            "no visible difference, or ragged edges"),
    MISTAKE("G-z", image_plane_vector, place_only_x_and_y, "x and y right, z = 0",
            "a vector has three components, [0], [1] and [2]. The last one is missing.",
            "blank, or a picture from the wrong side"),
    MISTAKE("D-far", with_unit_distance, only_where_the_plane_is_far, "only if d > 1",
            "a plane that is nearer than 1 is moved away in the same way: w and h grow with it.",
            "the same picture, but d is not always 1"),
    MISTAKE("D-near", with_unit_distance, only_where_the_plane_is_near, "only if d < 1",
            "a plane that is farther than 1 is moved nearer in the same way: w and h shrink with "
            "it.",
            "the same picture, but d is not always 1"),
    {0},
};
