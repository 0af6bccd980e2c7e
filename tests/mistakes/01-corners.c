// 01-corners.c - wrong answers to exercise 01.
#include "exercises/01-corners.h"

#include "tests/mistakes/mistakes.h"

static vec3 whole_width_and_height(Camera c)
{
    return c.distance * c.forward - c.width * c.right + c.height * c.up;
}

static vec3 down_for_up(Camera c)
{
    return c.distance * c.forward - c.width / 2 * c.right - c.height / 2 * c.up;
}

static vec3 right_for_left(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.height / 2 * c.up;
}

static vec3 left_for_right(Camera c)
{
    return c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
}

static vec3 forward_without_distance(Camera c)
{
    return c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
}

static vec3 point_for_vector(Camera c)
{
    return c.origin + left_for_right(c);
}

static vec3 point_minus_eye(Camera c)
{
    return left_for_right(c) - c.origin;
}

static vec3 counted_from_the_middle(Camera c)
{
    return c.distance * c.forward + 0.3 * c.width * c.right + 0.1 * c.height * c.up;
}

static vec3 across_10_up_30(Camera c)
{
    return image_plane_vector(c, 0.1, 0.3);
}

static vec3 down_from_the_top(Camera c)
{
    return image_plane_vector(c, 0.3, 0.9);
}

static vec3 width_for_both(Camera c)
{
    return c.distance * c.forward - c.width / 2 * c.right + c.width / 2 * c.up;
}

static vec3 right_width_for_both(Camera c)
{
    return c.distance * c.forward + c.width / 2 * c.right + c.width / 2 * c.up;
}

static vec3 behind_the_eye(Camera c)
{
    return -c.distance * c.forward - c.width / 2 * c.right + c.height / 2 * c.up;
}

static vec3 height_not_halved(Camera c)
{
    return c.distance * c.forward - c.width / 2 * c.right + c.height * c.up;
}

static vec3 right_up_swapped(Camera c)
{
    return c.distance * c.forward - c.width / 2 * c.up + c.height / 2 * c.right;
}

static vec3 general_from_the_middle(Camera c, double s, double t)
{
    return c.distance * c.forward + s * c.width * c.right + t * c.height * c.up;
}

static vec3 general_t_downward(Camera c, double s, double t)
{
    return c.distance * c.forward + (s - 0.5) * c.width * c.right - (t - 0.5) * c.height * c.up;
}

static vec3 general_swapped(Camera c, double s, double t)
{
    return c.distance * c.forward + (t - 0.5) * c.width * c.right + (s - 0.5) * c.height * c.up;
}

static vec3 general_without_width(Camera c, double s, double t)
{
    return c.distance * c.forward + (s - 0.5) * c.right + (t - 0.5) * c.up;
}

static vec3 general_clamped(Camera c, double s, double t)
{
    s = s < 0 ? 0 : s > 1 ? 1 : s;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}

static Camera only_the_distance(Camera c)
{
    c.distance = 1;
    return c;
}

static Camera times_the_distance(Camera c)
{
    c.width *= c.distance;
    c.height *= c.distance;
    c.distance = 1;
    return c;
}

static Camera divided_by_one(Camera c)
{
    c.distance = 1;
    c.width /= c.distance;
    c.height /= c.distance;
    return c;
}

static Camera eye_moved_to_the_plane(Camera c)
{
    Camera same = {c.origin + (c.distance - 1) * c.forward,
                   c.right,
                   c.up,
                   c.forward,
                   1,
                   c.width / c.distance,
                   c.height / c.distance};
    return same;
}

const Mistake mistakes[] = {
    MISTAKE("C1", upper_left, whole_width_and_height, "the whole width and height, not half"),
    MISTAKE("C2", upper_left, down_for_up, "the sign of u"),
    MISTAKE("C3", upper_left, right_for_left, "the sign of r"),
    MISTAKE("C3-right", upper_right, left_for_right, "the sign of r"),
    MISTAKE("C4", upper_left, forward_without_distance, "f in place of d f"),
    MISTAKE("C5", upper_left, point_for_vector, "the point, not the vector from the eye"),
    MISTAKE("C5-minus", upper_left, point_minus_eye, "the eye subtracted from a vector"),
    MISTAKE("C6", across_30_up_10, counted_from_the_middle, "30% and 10% from the middle"),
    MISTAKE("C6-swap", across_30_up_10, across_10_up_30, "10% across, 30% up"),
    MISTAKE("C6-top", across_30_up_10, down_from_the_top, "10% down from the top"),
    MISTAKE("C7", upper_left, width_for_both, "w for both"),
    MISTAKE("C7-right", upper_right, right_width_for_both, "w for both"),
    MISTAKE("C9", upper_left, behind_the_eye, "-d f"),
    MISTAKE("C1-h", upper_left, height_not_halved, "h not halved"),
    MISTAKE("C-ru", upper_left, right_up_swapped, "r and u swapped"),
    MISTAKE("G-middle", image_plane_vector, general_from_the_middle, "s, t from the middle"),
    MISTAKE("G-down", image_plane_vector, general_t_downward, "t downward"),
    MISTAKE("G-swap", image_plane_vector, general_swapped, "s and t swapped"),
    MISTAKE("G-unit", image_plane_vector, general_without_width, "w and h left out"),
    MISTAKE("G-clamp", image_plane_vector, general_clamped, "s and t held in 0..1"),
    MISTAKE("D-only", with_unit_distance, only_the_distance, "w and h left as they were"),
    MISTAKE("D-times", with_unit_distance, times_the_distance, "w d and h d"),
    MISTAKE("D-order", with_unit_distance, divided_by_one, "d set to 1 before it divides"),
    MISTAKE("D-eye", with_unit_distance, eye_moved_to_the_plane, "the eye moved forward"),
    {0},
};
