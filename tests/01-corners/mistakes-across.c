// mistakes-across.c - wrong ways to the point 30% across and 10% up.
#include "exercises/01-corners.h"
#include "tests/judge/mistake.h"

static vec3 from_the_middle(Camera c)
{
    return c.distance * c.forward + 0.3 * c.width * c.right + 0.1 * c.height * c.up;
}

static vec3 backwards_from_the_middle(Camera c)
{
    return c.distance * c.forward - 0.3 * c.width * c.right - 0.1 * c.height * c.up;
}

static vec3 across_from_the_middle(Camera c)
{
    return c.distance * c.forward + 0.3 * c.width * c.right - 0.4 * c.height * c.up;
}

static vec3 up_from_the_middle(Camera c)
{
    return c.distance * c.forward - 0.2 * c.width * c.right + 0.1 * c.height * c.up;
}

static vec3 shares_of_the_half(Camera c)
{
    return c.distance * c.forward + 0.3 * c.width / 2 * c.right + 0.1 * c.height / 2 * c.up;
}

static vec3 halved_twice(Camera c)
{
    return c.distance * c.forward + (0.3 - 0.5) * c.width / 2 * c.right +
           (0.1 - 0.5) * c.height / 2 * c.up;
}

static vec3 numbers_plus_vector(Camera c)
{
    return (0.3 - 0.5) * c.width + (0.1 - 0.5) * c.height + c.distance * c.forward;
}

static vec3 across_10_up_30(Camera c)
{
    return image_plane_vector(c, 0.1, 0.3);
}

static vec3 down_from_the_top(Camera c)
{
    return image_plane_vector(c, 0.3, 0.9);
}

static vec3 back_from_the_right(Camera c)
{
    return image_plane_vector(c, 0.7, 0.1);
}

static vec3 from_the_upper_right(Camera c)
{
    return image_plane_vector(c, 0.7, 0.9);
}

static vec3 up_from_the_top(Camera c)
{
    return upper_left(c) + 0.3 * c.width * c.right + 0.1 * c.height * c.up;
}

static vec3 shares_of_1(Camera c)
{
    return c.distance * c.forward - 0.2 * c.right - 0.4 * c.up;
}

static vec3 shares_minus_halves(Camera c)
{
    return c.distance * c.forward + (0.3 - c.width / 2) * c.right + (0.1 - c.height / 2) * c.up;
}

static vec3 percent_as_numbers(Camera c)
{
    return image_plane_vector(c, 30, 10);
}

static vec3 whole_numbers_divided(Camera c)
{
    return image_plane_vector(c, 30 / 100, 10 / 100);
}

static vec3 thirty_twice(Camera c)
{
    return image_plane_vector(c, 0.3, 0.3);
}

static vec3 as_the_deck_draws_it(Camera c)
{
    return image_plane_vector(c, 0.5, 0.25);
}

static vec3 forward_without_distance(Camera c)
{
    return c.forward - 0.2 * c.width * c.right - 0.4 * c.height * c.up;
}

static vec3 nothing_ahead(Camera c)
{
    return -0.2 * c.width * c.right - 0.4 * c.height * c.up;
}

static vec3 behind_the_eye(Camera c)
{
    return -c.distance * c.forward - 0.2 * c.width * c.right - 0.4 * c.height * c.up;
}

static vec3 point_for_vector(Camera c)
{
    return c.origin + image_plane_vector(c, 0.3, 0.1);
}

static vec3 point_minus_eye(Camera c)
{
    return image_plane_vector(c, 0.3, 0.1) - c.origin;
}

static vec3 width_for_both(Camera c)
{
    return c.distance * c.forward - 0.2 * c.width * c.right - 0.4 * c.width * c.up;
}

static vec3 sizes_swapped(Camera c)
{
    return c.distance * c.forward - 0.2 * c.height * c.right - 0.4 * c.width * c.up;
}

static vec3 right_and_up_swapped(Camera c)
{
    return c.distance * c.forward - 0.2 * c.width * c.up - 0.4 * c.height * c.right;
}

static vec3 axes_of_the_world(Camera c)
{
    return vec3_of(-0.2 * c.width, -0.4 * c.height, c.distance);
}

static vec3 of_length_1(Camera c)
{
    return vec3_unit(image_plane_vector(c, 0.3, 0.1));
}

const Mistake across_mistakes[] = {
    MISTAKE("C6", across_30_up_10, from_the_middle, "d f + 0.3 w r + 0.1 h u",
            "the steps start from the middle. Across starts at the left edge, and up starts at the "
            "bottom.",
            "the middle of the view in the lower left corner"),
    MISTAKE("C6-minus", across_30_up_10, backwards_from_the_middle, "d f - 0.3 w r - 0.1 h u",
            "30% to the left and 10% down from the middle. Across starts at the left edge, and up "
            "starts at the bottom.",
            "the point too far left and too high"),
    MISTAKE("C6-x", across_30_up_10, across_from_the_middle, "d f + 0.3 w r - 0.4 h u",
            "the height is right, but across starts from the middle instead of the left edge.",
            "the point half a picture too far right"),
    MISTAKE("C6-y", across_30_up_10, up_from_the_middle, "d f - 0.2 w r + 0.1 h u",
            "across is right, but up starts from the middle instead of the bottom.",
            "the point half a picture too high"),
    MISTAKE("C6-half", across_30_up_10, shares_of_the_half, "d f + 0.3 w/2 r + 0.1 h/2 u",
            "30% and 10% of half the plane, from the middle. 30% means 30% of the whole width, "
            "starting at the left edge.",
            "the point right of the middle and above it"),
    MISTAKE("C6-twice", across_30_up_10, halved_twice,
            "d f + (0.3 - 1/2) w/2 r + (0.1 - 1/2) h/2 u",
            "halved twice. After subtracting 1/2 you start from the middle already, and from edge "
            "to edge it is the whole width.",
            "the point only half as far from the middle"),
    MISTAKE("C6-number", across_30_up_10, numbers_plus_vector,
            "d f + (0.3 - 1/2) w + (0.1 - 1/2) h",
            "adding a number to a vector adds it to every component. To move across or up, "
            "multiply r or u by the number.",
            "the point off to one side"),
    MISTAKE("C6-swap", across_30_up_10, across_10_up_30, "d f - 0.4 w r - 0.2 h u",
            "this is 10% across and 30% up.", "the point too far left and too high"),
    MISTAKE("C6-top", across_30_up_10, down_from_the_top, "d f - 0.2 w r + 0.4 h u",
            "this is 10% down from the top; the exercise asks for 10% up from the bottom.",
            "the point near the top: upside down"),
    MISTAKE("C6-right", across_30_up_10, back_from_the_right, "d f + 0.2 w r - 0.4 h u",
            "this is 30% from the right edge. Across starts at the left edge.",
            "mirrored: left and right swapped"),
    MISTAKE("C6-both", across_30_up_10, from_the_upper_right, "d f + 0.2 w r + 0.4 h u",
            "both signs are reversed. This point is as far from the upper right corner as the "
            "right one is from the lower left corner.",
            "turned by 180 degrees"),
    MISTAKE("C6-over", across_30_up_10, up_from_the_top, "d f - 0.2 w r + 0.6 h u",
            "up starts at the top edge, so the point is above the plane. Up starts at the bottom.",
            "the point above the picture"),
    MISTAKE(
        "C6-unit", across_30_up_10, shares_of_1, "d f - 0.2 r - 0.4 u",
        "30% and 10% of 1, not of the plane. The length of 30% depends on the width of the plane.",
        "right if w = h = 1"),
    MISTAKE("C6-mixed", across_30_up_10, shares_minus_halves, "d f + (0.3 - w/2) r + (0.1 - h/2) u",
            "0.3 is a share and w/2 is a length. A share becomes a length only when you multiply "
            "it by one.",
            "right if w = h = 1"),
    MISTAKE("C6-percent", across_30_up_10, percent_as_numbers, "d f + 29.5 w r + 9.5 h u",
            "30 times the width and 10 times the height. One percent is a hundredth.",
            "the point far outside the picture"),
    MISTAKE("C6-int", across_30_up_10, whole_numbers_divided, "d f - w/2 r - h/2 u",
            "this is the lower left corner. In C, 30 / 100 is an integer division, and its result "
            "is 0.",
            "the point in the corner"),
    MISTAKE("C6-same", across_30_up_10, thirty_twice, "d f - 0.2 w r - 0.2 h u",
            "30% in both directions, but up must be 10%.", "the point too high"),
    MISTAKE("C6-drawn", across_30_up_10, as_the_deck_draws_it, "d f - 0.25 h u",
            "this is the end of the deck's red vector, at 50% and 25%. The drawing and the text "
            "differ here: follow the text.",
            "the point in the middle column"),
    MISTAKE("C6-f", across_30_up_10, forward_without_distance, "f - 0.2 w r - 0.4 h u",
            "f has length 1, and the plane is not at distance 1: the step ahead is d f.",
            "right if d = 1; if not, a narrower or wider view"),
    MISTAKE("C6-flat", across_30_up_10, nothing_ahead, "-0.2 w r - 0.4 h u",
            "the step d f is missing. The vector goes only sideways and never reaches the plane.",
            "blank: the rays go off sideways"),
    MISTAKE("C6-back", across_30_up_10, behind_the_eye, "-d f - 0.2 w r - 0.4 h u",
            "f points ahead, to the plane. This vector goes backwards from the eye.",
            "blank, or the scene behind the camera, mirrored"),
    MISTAKE("C6-p", across_30_up_10, point_for_vector, "p + d f - 0.2 w r - 0.4 h u",
            "this is the point itself. The vector from the eye to it does not depend on where the "
            "eye is.",
            "right if the eye is at the origin; if not, the view is off to one side"),
    MISTAKE("C6-minus-p", across_30_up_10, point_minus_eye, "d f - 0.2 w r - 0.4 h u - p",
            "the vector starts at the eye already, so do not subtract the eye again.",
            "right if the eye is at the origin; if not, the view is off to one side"),
    MISTAKE("C6-w", across_30_up_10, width_for_both, "d f - 0.2 w r - 0.4 w u",
            "the width is used both times. 10% up is a share of the height.",
            "right if w = h; if not, too low or too high"),
    MISTAKE("C6-sizes", across_30_up_10, sizes_swapped, "d f - 0.2 h r - 0.4 w u",
            "w is the length along r and h the length along u. Here they are swapped.",
            "right if w = h; if not, squashed or stretched"),
    MISTAKE("C6-ru", across_30_up_10, right_and_up_swapped, "d f - 0.2 w u - 0.4 h r",
            "r points across and u points up. Here they are swapped.",
            "mirrored in the diagonal: rows become columns"),
    MISTAKE("C6-axes", across_30_up_10, axes_of_the_world, "(-0.2 w, -0.4 h, d)",
            "these steps go along the axes of the world. The camera has its own axes: r, u and f.",
            "right for the deck's camera; turning the camera changes nothing"),
    MISTAKE("C6-length", across_30_up_10, of_length_1, "the unit vector in that direction",
            "the direction is right, but the vector no longer ends on the plane. Its length must "
            "be the distance to the point.",
            "the same picture; only distances along the rays differ"),
    {0},
};
