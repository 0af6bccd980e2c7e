// mistakes-ways.c - wrong upper corners: a step in the wrong direction, or from the wrong point.
#include "tests/01-corners/mistakes.h"

static vec3 down_for_up(Camera c, double side)
{
    return c.distance * c.forward + side * c.width / 2 * c.right - c.height / 2 * c.up;
}

static vec3 other_side(Camera c, double side)
{
    return c.distance * c.forward - side * c.width / 2 * c.right + c.height / 2 * c.up;
}

static vec3 opposite_corner(Camera c, double side)
{
    return c.distance * c.forward - side * c.width / 2 * c.right - c.height / 2 * c.up;
}

static vec3 point_for_vector(Camera c, double side)
{
    return c.origin + c.distance * c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up;
}

static vec3 point_minus_eye(Camera c, double side)
{
    return c.distance * c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up - c.origin;
}

static vec3 behind_the_eye(Camera c, double side)
{
    return -c.distance * c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up;
}

static vec3 corner_to_eye(Camera c, double side)
{
    return -c.distance * c.forward - side * c.width / 2 * c.right - c.height / 2 * c.up;
}

static vec3 right_twice(Camera c, double side)
{
    return c.distance * c.forward + side * c.width / 2 * c.right + c.height / 2 * c.right;
}

static vec3 up_twice(Camera c, double side)
{
    return c.distance * c.forward + side * c.width / 2 * c.up + c.height / 2 * c.up;
}

static vec3 up_and_forward_swapped(Camera c, double side)
{
    return c.distance * c.up + side * c.width / 2 * c.right + c.height / 2 * c.forward;
}

static vec3 right_and_forward_swapped(Camera c, double side)
{
    return c.distance * c.right + side * c.width / 2 * c.forward + c.height / 2 * c.up;
}

static vec3 axes_of_the_world(Camera c, double side)
{
    return vec3_of(side * c.width / 2, c.height / 2, c.distance);
}

static vec3 number_plus_vector(Camera c, double side)
{
    return c.distance + c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up;
}

static vec3 sizes_without_directions(Camera c, double side)
{
    return c.distance * c.forward + side * c.width / 2 + c.height / 2;
}

static vec3 right_and_up_swapped(Camera c)
{
    return c.distance * c.forward - c.width / 2 * c.up + c.height / 2 * c.right;
}

static vec3 counted_from_the_corner(Camera c)
{
    return c.distance * c.forward + c.height * c.up;
}

ON_BOTH_SIDES(down_for_up)
ON_BOTH_SIDES(other_side)
ON_BOTH_SIDES(opposite_corner)
ON_BOTH_SIDES(point_for_vector)
ON_BOTH_SIDES(point_minus_eye)
ON_BOTH_SIDES(behind_the_eye)
ON_BOTH_SIDES(corner_to_eye)
ON_BOTH_SIDES(right_twice)
ON_BOTH_SIDES(up_twice)
ON_BOTH_SIDES(up_and_forward_swapped)
ON_BOTH_SIDES(right_and_forward_swapped)
ON_BOTH_SIDES(axes_of_the_world)
ON_BOTH_SIDES(number_plus_vector)
ON_BOTH_SIDES(sizes_without_directions)

const Mistake corner_way_mistakes[] = {
    SIDES("C2", down_for_up, "d f - w/2 r - h/2 u", "d f + w/2 r - h/2 u",
          "u points up, so this goes down to the bottom edge.", "upside down"),
    SIDES("C3", other_side, "d f + w/2 r + h/2 u", "d f - w/2 r + h/2 u",
          "r points to the right. This is the other corner of the top edge.",
          "mirrored: left and right swapped"),
    SIDES("C2-C3", opposite_corner, "d f + w/2 r - h/2 u", "d f - w/2 r - h/2 u",
          "both steps to the side have the wrong sign. This is the opposite corner.",
          "turned by 180 degrees"),
    SIDES("C5", point_for_vector, "p + d f - w/2 r + h/2 u", "p + d f + w/2 r + h/2 u",
          "this is the corner as a point of the world. The vector from the eye to it does not "
          "depend on where the eye is.",
          "right if the eye is at the origin; if not, the view is off to one side"),
    SIDES("C5-minus", point_minus_eye, "d f - w/2 r + h/2 u - p", "d f + w/2 r + h/2 u - p",
          "the vector starts at the eye already, so do not subtract the eye again. p is subtracted "
          "from points, not from vectors.",
          "right if the eye is at the origin; if not, the view is off to one side"),
    SIDES("C9", behind_the_eye, "-d f - w/2 r + h/2 u", "-d f + w/2 r + h/2 u",
          "f points ahead, to the plane. This vector goes backwards from the eye.",
          "blank, or the scene behind the camera, mirrored"),
    SIDES("C9-all", corner_to_eye, "-(d f - w/2 r + h/2 u)", "-(d f + w/2 r + h/2 u)",
          "this is the vector back, from the corner to the eye.",
          "blank, or the scene behind the camera, upside down"),
    SIDES("C-rr", right_twice, "d f - w/2 r + h/2 r", "d f + w/2 r + h/2 r",
          "both steps go along r. The vector stays at the height of the middle.",
          "stripes from top to bottom: all rows are alike"),
    SIDES("C-uu", up_twice, "d f - w/2 u + h/2 u", "d f + w/2 u + h/2 u",
          "both steps go along u. The vector stays on the vertical line through the middle.",
          "stripes from left to right: all columns are alike"),
    SIDES("C-fu", up_and_forward_swapped, "d u - w/2 r + h/2 f", "d u + w/2 r + h/2 f",
          "f points to the plane and u to its top. Here they are swapped.",
          "the scene above the camera"),
    SIDES("C-fr", right_and_forward_swapped, "d r - w/2 f + h/2 u", "d r + w/2 f + h/2 u",
          "f points to the plane and r along it. Here they are swapped.",
          "the scene beside the camera"),
    SIDES("C-axes", axes_of_the_world, "(-w/2, h/2, d)", "(w/2, h/2, d)",
          "these steps go along the axes of the world. The camera has its own axes: r, u and f.",
          "right for the deck's camera; turning the camera changes nothing"),
    SIDES("C-plus", number_plus_vector, "d + f - w/2 r + h/2 u", "d + f + w/2 r + h/2 u",
          "adding a number to a vector adds d to every component of f. To go the distance d along "
          "f, multiply.",
          "the view is off to one side"),
    SIDES("C-number", sizes_without_directions, "d f - w/2 + h/2", "d f + w/2 + h/2",
          "adding a number to a vector adds it to every component. To move to the side or up, "
          "multiply r or u by the number.",
          "the view is off to one side"),
    MISTAKE("C-ru", upper_left, right_and_up_swapped, "d f - w/2 u + h/2 r",
            "r points across and u points up. Here they are swapped.",
            "mirrored in the diagonal: rows become columns"),
    MISTAKE(
        "C-corner", upper_left, counted_from_the_corner, "d f + h u",
        "this would be right from the lower left corner, but f reaches the middle of the plane.",
        "the middle of the view in the lower left corner"),
    {0},
};
