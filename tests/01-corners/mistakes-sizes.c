// mistakes-sizes.c - wrong upper corners: steps that are too long, too short, or missing.
#include "tests/01-corners/mistakes.h"

static vec3 whole_width_and_height(Camera c, double side)
{
    return c.distance * c.forward + side * c.width * c.right + c.height * c.up;
}

static vec3 whole_width(Camera c, double side)
{
    return c.distance * c.forward + side * c.width * c.right + c.height / 2 * c.up;
}

static vec3 whole_height(Camera c, double side)
{
    return c.distance * c.forward + side * c.width / 2 * c.right + c.height * c.up;
}

static vec3 all_halved(Camera c, double side)
{
    return (c.distance * c.forward + side * c.width * c.right + c.height * c.up) / 2;
}

static vec3 forward_without_distance(Camera c, double side)
{
    return c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up;
}

static vec3 nothing_ahead(Camera c, double side)
{
    return side * c.width / 2 * c.right + c.height / 2 * c.up;
}

static vec3 width_for_both(Camera c, double side)
{
    return c.distance * c.forward + side * c.width / 2 * c.right + c.width / 2 * c.up;
}

static vec3 height_for_both(Camera c, double side)
{
    return c.distance * c.forward + side * c.height / 2 * c.right + c.height / 2 * c.up;
}

static vec3 sizes_swapped(Camera c, double side)
{
    return c.distance * c.forward + side * c.height / 2 * c.right + c.width / 2 * c.up;
}

static vec3 middle_of_the_top(Camera c, double side)
{
    (void)side;
    return c.distance * c.forward + c.height / 2 * c.up;
}

static vec3 middle_of_the_side(Camera c, double side)
{
    return c.distance * c.forward + side * c.width / 2 * c.right;
}

static vec3 whole_numbers_halved(Camera c, double side)
{
    return c.distance * c.forward + 1 / 2 * (side * c.width * c.right + c.height * c.up);
}

static vec3 distance_times_all(Camera c, double side)
{
    return c.distance * (c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up);
}

static vec3 of_length_1(Camera c, double side)
{
    return vec3_unit(c.distance * c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up);
}

static vec3 divided_by_distance(Camera c, double side)
{
    return c.forward + (side * c.width / 2 * c.right + c.height / 2 * c.up) / c.distance;
}

ON_BOTH_SIDES(whole_width_and_height)
ON_BOTH_SIDES(whole_width)
ON_BOTH_SIDES(whole_height)
ON_BOTH_SIDES(all_halved)
ON_BOTH_SIDES(forward_without_distance)
ON_BOTH_SIDES(nothing_ahead)
ON_BOTH_SIDES(width_for_both)
ON_BOTH_SIDES(height_for_both)
ON_BOTH_SIDES(sizes_swapped)
ON_BOTH_SIDES(middle_of_the_top)
ON_BOTH_SIDES(middle_of_the_side)
ON_BOTH_SIDES(whole_numbers_halved)
ON_BOTH_SIDES(distance_times_all)
ON_BOTH_SIDES(of_length_1)
ON_BOTH_SIDES(divided_by_distance)

const Mistake corner_size_mistakes[] = {
    SIDES("C1", whole_width_and_height, "d f - w r + h u", "d f + w r + h u",
          "the whole width and height. f reaches the middle of the plane, and each edge is only "
          "half as far from there.",
          "everything at half its size"),
    SIDES("C1-w", whole_width, "d f - w r + h/2 u", "d f + w r + h/2 u",
          "the whole width. f reaches the middle of the plane, and the side is only half the width "
          "away from there.",
          "everything squeezed to half its width"),
    SIDES("C1-h", whole_height, "d f - w/2 r + h u", "d f + w/2 r + h u",
          "the whole height. f reaches the middle of the plane, and the top is only half the "
          "height away from there.",
          "everything squeezed to half its height"),
    SIDES("C1-all", all_halved, "(d f - w r + h u) / 2", "(d f + w r + h u) / 2",
          "the step ahead is halved too. It stops half way to the plane.",
          "everything at half its size"),
    SIDES("C4", forward_without_distance, "f - w/2 r + h/2 u", "f + w/2 r + h/2 u",
          "f has length 1, and the plane is not at distance 1: the step ahead is d f.",
          "right if d = 1; if not, a narrower or wider view"),
    SIDES("C4-flat", nothing_ahead, "-w/2 r + h/2 u", "w/2 r + h/2 u",
          "the step d f is missing. The vector goes only sideways and never reaches the plane.",
          "blank: the rays go off sideways"),
    SIDES("C7", width_for_both, "d f - w/2 r + w/2 u", "d f + w/2 r + w/2 u",
          "the width is used both times. How far the top is from the middle depends on the height.",
          "right if w = h; if not, squashed or stretched"),
    SIDES(
        "C7-h", height_for_both, "d f - h/2 r + h/2 u", "d f + h/2 r + h/2 u",
        "the height is used both times. How far the side is from the middle depends on the width.",
        "right if w = h; if not, squashed or stretched"),
    SIDES("C7-swap", sizes_swapped, "d f - h/2 r + w/2 u", "d f + h/2 r + w/2 u",
          "w is the length along r and h the length along u. Here they are swapped.",
          "right if w = h; if not, squashed or stretched"),
    SIDES("C-top", middle_of_the_top, "d f + h/2 u", "d f + h/2 u",
          "the step along r is missing. This vector ends in the middle of the top edge.",
          "stripes from left to right: all columns are alike"),
    SIDES("C-side", middle_of_the_side, "d f - w/2 r", "d f + w/2 r",
          "the step along u is missing. This vector ends in the middle of the side.",
          "stripes from top to bottom: all rows are alike"),
    SIDES("C-int", whole_numbers_halved, "d f", "d f",
          "only the vector to the middle is left. In C, 1 / 2 is an integer division, and its "
          "result is 0.",
          "one flat colour"),
    SIDES("C-times", distance_times_all, "d (f - w/2 r + h/2 u)", "d (f + w/2 r + h/2 u)",
          "the steps across and up are multiplied by d as well. The size of the plane does not "
          "depend on its distance.",
          "right if d = 1; if not, too small or too large"),
    SIDES("C-unit", of_length_1, "the unit vector in that direction",
          "the unit vector in that direction",
          "the direction is right, but the vector no longer ends on the plane. Its length must be "
          "the distance to the point.",
          "the same picture; only distances along the rays differ"),
    SIDES("C-one", divided_by_distance, "f - w/(2d) r + h/(2d) u", "f + w/(2d) r + h/(2d) u",
          "the direction is right, but the vector ends at distance 1 and not on the plane.",
          "the same picture; only distances along the rays differ"),
    {0},
};
