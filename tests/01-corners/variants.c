// variants.c - right answers to exercise 01, written in other ways.
#include "exercises/01-corners.h"

#include "tests/proof/variants.h"

#include <stdio.h>

static vec3 leg_by_leg(Camera c)
{
    vec3 way = c.forward * c.distance;
    way += c.up * c.height * 0.5;
    way -= c.right * c.width * 0.5;
    return way;
}

static vec3 halved_at_the_end(Camera c)
{
    return (2 * c.distance * c.forward - c.width * c.right + c.height * c.up) / 2;
}

static vec3 as_a_place(Camera c)
{
    return image_plane_vector(c, 0, 1);
}

static vec3 component_by_component(Camera c)
{
    vec3 way = {0, 0, 0, 0};
    for (int i = 0; i < 3; i++)
        way[i] =
            c.distance * c.forward[i] - 0.5 * (c.width * c.right[i]) + 0.5 * (c.height * c.up[i]);
    return way;
}

static vec3 from_the_other_corner(Camera c)
{
    return upper_left(c) + c.width * c.right;
}

static vec3 with_printf_left_in(Camera c)
{
    vec3 way = c.distance * c.forward + (c.width * c.right + c.height * c.up) / 2;
    printf("upper right: %g %g %g\n", way[0], way[1], way[2]);
    return way;
}

static vec3 mirrored_in_the_middle(Camera c)
{
    vec3 lower_left = c.distance * c.forward - c.width / 2 * c.right - c.height / 2 * c.up;
    return 2 * c.distance * c.forward - lower_left;
}

static vec3 from_the_lower_left_corner(Camera c)
{
    vec3 lower_left = upper_left(c) - c.height * c.up;
    return lower_left + 30 * c.width / 100 * c.right + 10 * c.height / 100 * c.up;
}

static vec3 worked_out_by_hand(Camera c)
{
    return c.distance * c.forward - 0.2 * c.width * c.right - 0.4 * c.height * c.up;
}

static vec3 between(vec3 from, vec3 to, double share)
{
    return (1 - share) * from + share * to;
}

static vec3 between_the_corners(Camera c, double s, double t)
{
    vec3 left = upper_left(c), right = upper_right(c), down = -c.height * c.up;
    return between(between(left + down, right + down, s), between(left, right, s), t);
}

static vec3 multiplied_out(Camera c, double s, double t)
{
    return c.distance * c.forward + s * c.width * c.right - c.width / 2 * c.right +
           t * c.height * c.up - c.height / 2 * c.up;
}

static vec3 point_minus_eye(Camera c, double s, double t)
{
    vec3 point = c.origin + c.distance * c.forward;
    point += (2 * s - 1) * c.width / 2 * c.right;
    point += (2 * t - 1) * c.height / 2 * c.up;
    return point - c.origin;
}

static Camera times_the_reciprocal(Camera c)
{
    double factor = 1 / c.distance;
    return (Camera){.origin = c.origin,
                    .right = c.right,
                    .up = c.up,
                    .forward = c.forward,
                    .distance = 1,
                    .width = factor * c.width,
                    .height = factor * c.height};
}

static Camera distance_last(Camera c)
{
    Camera same = c;
    same.height = c.height / c.distance;
    same.width = c.width / c.height * same.height;
    same.distance /= c.distance;
    return same;
}

typedef struct {
    vec3 right, up, forward; // from the middle to an edge, and from the eye to the plane
} Steps;

static Steps steps_of(Camera c)
{
    return (Steps){c.width / 2 * c.right, c.height / 2 * c.up, c.distance * c.forward};
}

static vec3 by_steps(Camera c)
{
    Steps steps = steps_of(c);
    return steps.forward + steps.up - steps.right;
}

// The frame's vectors are the columns.
static vec3 by_a_matrix(Camera c)
{
    double matrix[3][3], way[3] = {c.width / 2, c.height / 2, c.distance};
    vec3 v = {0, 0, 0, 0};
    for (int row = 0; row < 3; row++) {
        matrix[row][0] = c.right[row];
        matrix[row][1] = c.up[row];
        matrix[row][2] = c.forward[row];
        for (int column = 0; column < 3; column++)
            v[row] += matrix[row][column] * way[column];
    }
    return v;
}

static vec3 mean_of_corners(Camera c)
{
    vec3 left = upper_left(c), right = upper_right(c), down = -c.height * c.up;
    vec3 corners[] = {left, right, left + down, right + down};
    double shares[] = {0.7 * 0.1, 0.3 * 0.1, 0.7 * 0.9, 0.3 * 0.9};
    vec3 sum = {0, 0, 0, 0};
    for (int i = 0; i < 4; i++)
        sum += shares[i] * corners[i];
    return sum;
}

static vec3 in_percent(Camera c)
{
    int across = 30 - 50, up = 10 - 50;
    return c.distance * c.forward + across * c.width * c.right / 100 + up * c.height * c.up / 100;
}

// From -1 to 1, and then halves of the plane.
static vec3 from_minus_1_to_1(Camera c, double s, double t)
{
    double x = 2 * s - 1, y = 2 * t - 1;
    return c.distance * c.forward + x * (c.width / 2) * c.right + y * (c.height / 2) * c.up;
}

static double along(Camera c, int axis, double x, double y, double z)
{
    return fma(z, c.forward[axis], fma(y, c.up[axis], x * c.right[axis]));
}

static vec3 with_fma(Camera c, double s, double t)
{
    double x = fma(s, c.width, -c.width / 2), y = fma(t, c.height, -c.height / 2);
    return vec3_of(along(c, 0, x, y, c.distance), along(c, 1, x, y, c.distance),
                   along(c, 2, x, y, c.distance));
}

static vec3 in_long_double(Camera c, double s, double t)
{
    vec3 v = {0, 0, 0, 0};
    for (int i = 0; i < 3; i++)
        v[i] = (double)((long double)c.distance * c.forward[i] +
                        ((long double)s - 0.5L) * c.width * c.right[i] +
                        ((long double)t - 0.5L) * c.height * c.up[i]);
    return v;
}

// By similar triangles: the plane at distance 1, and back.
static vec3 at_unit_distance_first(Camera c, double s, double t)
{
    double w = c.width / c.distance, h = c.height / c.distance;
    return c.distance * (c.forward + (s - 0.5) * w * c.right + (t - 0.5) * h * c.up);
}

static Camera by_the_angles(Camera c)
{
    double half_across = atan2(c.width / 2, c.distance), half_up = atan2(c.height / 2, c.distance);
    c.width = 2 * tan(half_across);
    c.height = 2 * tan(half_up);
    c.distance = 1;
    return c;
}

static const Variant variants[] = {
    VARIANT(upper_left, leg_by_leg, "leg by leg, up before right"),
    VARIANT(upper_left, halved_at_the_end, "doubled, and halved at the end"),
    VARIANT(upper_left, as_a_place, "the place s = 0, t = 1"),
    VARIANT(upper_left, component_by_component, "a loop over the components"),
    VARIANT(upper_right, from_the_other_corner, "upper_left plus the width"),
    VARIANT(upper_right, with_printf_left_in, "printf left in"),
    VARIANT(upper_right, mirrored_in_the_middle, "the lower left corner mirrored in the middle"),
    VARIANT(across_30_up_10, from_the_lower_left_corner, "from the lower left corner, in percent"),
    VARIANT(across_30_up_10, worked_out_by_hand, "with the shares worked out by hand"),
    VARIANT(image_plane_vector, between_the_corners, "between the four corners, with a helper"),
    VARIANT(image_plane_vector, multiplied_out, "multiplied out"),
    VARIANT(image_plane_vector, point_minus_eye, "the point of the world minus the eye"),
    VARIANT(with_unit_distance, times_the_reciprocal, "a new camera, times 1 / d"),
    VARIANT(with_unit_distance, distance_last, "the width by its ratio to the height"),
    VARIANT(upper_left, by_steps, "a struct of steps"),
    VARIANT(upper_right, by_a_matrix, "a matrix whose columns are the frame"),
    VARIANT(across_30_up_10, mean_of_corners, "a weighted mean of the four corners"),
    VARIANT(across_30_up_10, in_percent, "in whole percent, divided last"),
    VARIANT(image_plane_vector, from_minus_1_to_1, "by way of -1 to 1"),
    VARIANT(image_plane_vector, with_fma, "with fma, axis by axis"),
    VARIANT(image_plane_vector, in_long_double, "in long double"),
    VARIANT(image_plane_vector, at_unit_distance_first, "at distance 1, then d times as far"),
    VARIANT(with_unit_distance, by_the_angles, "with atan2 and tan of the angles"),
    {0},
};
OF_STEM(variants)
