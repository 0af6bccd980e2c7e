// wrong.c - wrong answers to exercise 01.
#include "exercises/01-corners.h"

#include "tests/judge/known.h"

// ---- wrong upper corners: steps that are too long, too short, or missing ------------------------

// One slip, two corners: side is -1 for the left corner and 1 for the right one.
#define SIDES(id, left, right, why, picture, statement)                                            \
    WRONG(upper_left, id, left, why, picture)                                                      \
    {                                                                                              \
        const double side = -1;                                                                    \
        (void)side;                                                                                \
        statement;                                                                                 \
    }                                                                                              \
    WRONG(upper_right, id "-right", right, why, picture)                                           \
    {                                                                                              \
        const double side = 1;                                                                     \
        (void)side;                                                                                \
        statement;                                                                                 \
    }

SIDES("C1", "d f - w r + h u", "d f + w r + h u",
      "the whole width and height. f reaches the middle of the plane, and each edge is only half "
      "as far from there.",
      "everything at half its size",
      return c.distance * c.forward + side * c.width * c.right + c.height * c.up)
SIDES("C1-w", "d f - w r + h/2 u", "d f + w r + h/2 u",
      "the whole width. f reaches the middle of the plane, and the side is only half the width "
      "away from there.",
      "everything squeezed to half its width",
      return c.distance * c.forward + side * c.width * c.right + c.height / 2 * c.up)
SIDES("C1-h", "d f - w/2 r + h u", "d f + w/2 r + h u",
      "the whole height. f reaches the middle of the plane, and the top is only half the height "
      "away from there.",
      "everything squeezed to half its height",
      return c.distance * c.forward + side * c.width / 2 * c.right + c.height * c.up)
SIDES("C1-all", "(d f - w r + h u) / 2", "(d f + w r + h u) / 2",
      "the step ahead is halved too. It stops half way to the plane.",
      "everything at half its size",
      return (c.distance * c.forward + side * c.width * c.right + c.height * c.up) / 2)
SIDES("C4", "f - w/2 r + h/2 u", "f + w/2 r + h/2 u",
      "f has length 1, and the plane is not at distance 1: the step ahead is d f.",
      "right if d = 1; if not, a narrower or wider view",
      return c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up)
SIDES("C4-flat", "-w/2 r + h/2 u", "w/2 r + h/2 u",
      "the step d f is missing. The vector goes only sideways and never reaches the plane.",
      "blank: the rays go off sideways", return side * c.width / 2 * c.right + c.height / 2 * c.up)
SIDES("C7", "d f - w/2 r + w/2 u", "d f + w/2 r + w/2 u",
      "the width is used both times. How far the top is from the middle depends on the height.",
      "right if w = h; if not, squashed or stretched",
      return c.distance * c.forward + side * c.width / 2 * c.right + c.width / 2 * c.up)
SIDES("C7-h", "d f - h/2 r + h/2 u", "d f + h/2 r + h/2 u",
      "the height is used both times. How far the side is from the middle depends on the width.",
      "right if w = h; if not, squashed or stretched",
      return c.distance * c.forward + side * c.height / 2 * c.right + c.height / 2 * c.up)
SIDES("C7-swap", "d f - h/2 r + w/2 u", "d f + h/2 r + w/2 u",
      "w is the length along r and h the length along u. Here they are swapped.",
      "right if w = h; if not, squashed or stretched",
      return c.distance * c.forward + side * c.height / 2 * c.right + c.width / 2 * c.up)
SIDES("C-top", "d f + h/2 u", "d f + h/2 u",
      "the step along r is missing. This vector ends in the middle of the top edge.",
      "stripes from left to right: all columns are alike",
      return c.distance * c.forward + c.height / 2 * c.up)
SIDES("C-side", "d f - w/2 r", "d f + w/2 r",
      "the step along u is missing. This vector ends in the middle of the side.",
      "stripes from top to bottom: all rows are alike",
      return c.distance * c.forward + side * c.width / 2 * c.right)
SIDES("C-int", "d f", "d f",
      "only the vector to the middle is left. In C, 1 / 2 is an integer division, and its result "
      "is 0.",
      "one flat colour",
      return c.distance * c.forward + 1 / 2 * (side * c.width * c.right + c.height * c.up))
SIDES("C-times", "d (f - w/2 r + h/2 u)", "d (f + w/2 r + h/2 u)",
      "the steps across and up are multiplied by d as well. The size of the plane does not depend "
      "on its distance.",
      "right if d = 1; if not, too small or too large",
      return c.distance * (c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up))
SIDES("C-unit", "the unit vector in that direction", "the unit vector in that direction",
      "the direction is right, but the vector no longer ends on the plane. Its length must be the "
      "distance to the point.",
      "the same picture; only distances along the rays differ",
      return vec3_unit(c.distance * c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up))
SIDES("C-one", "f - w/(2d) r + h/(2d) u", "f + w/(2d) r + h/(2d) u",
      "the direction is right, but the vector ends at distance 1 and not on the plane.",
      "the same picture; only distances along the rays differ",
      return c.forward + (side * c.width / 2 * c.right + c.height / 2 * c.up) / c.distance)

// ---- wrong upper corners: a step in the wrong direction, or from the wrong point ----------------

SIDES("C2", "d f - w/2 r - h/2 u", "d f + w/2 r - h/2 u",
      "u points up, so this goes down to the bottom edge.", "upside down",
      return c.distance * c.forward + side * c.width / 2 * c.right - c.height / 2 * c.up)
SIDES("C3", "d f + w/2 r + h/2 u", "d f - w/2 r + h/2 u",
      "r points to the right. This is the other corner of the top edge.",
      "mirrored: left and right swapped",
      return c.distance * c.forward - side * c.width / 2 * c.right + c.height / 2 * c.up)
SIDES("C2-C3", "d f + w/2 r - h/2 u", "d f - w/2 r - h/2 u",
      "both steps to the side have the wrong sign. This is the opposite corner.",
      "turned by 180 degrees",
      return c.distance * c.forward - side * c.width / 2 * c.right - c.height / 2 * c.up)
SIDES("C5", "p + d f - w/2 r + h/2 u", "p + d f + w/2 r + h/2 u",
      "this is the corner as a point of the world. The vector from the eye to it does not depend "
      "on where the eye is.",
      "right if the eye is at the origin; if not, the view is off to one side",
      return c.origin + c.distance * c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up)
SIDES("C5-minus", "d f - w/2 r + h/2 u - p", "d f + w/2 r + h/2 u - p",
      "the vector starts at the eye already, so do not subtract the eye again. p is subtracted "
      "from points, not from vectors.",
      "right if the eye is at the origin; if not, the view is off to one side",
      return c.distance * c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up - c.origin)
SIDES("C9", "-d f - w/2 r + h/2 u", "-d f + w/2 r + h/2 u",
      "f points ahead, to the plane. This vector goes backwards from the eye.",
      "blank, or the scene behind the camera, mirrored",
      return -c.distance * c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up)
SIDES("C9-all", "-(d f - w/2 r + h/2 u)", "-(d f + w/2 r + h/2 u)",
      "this is the vector back, from the corner to the eye.",
      "blank, or the scene behind the camera, upside down",
      return -c.distance * c.forward - side * c.width / 2 * c.right - c.height / 2 * c.up)
SIDES("C-rr", "d f - w/2 r + h/2 r", "d f + w/2 r + h/2 r",
      "both steps go along r. The vector stays at the height of the middle.",
      "stripes from top to bottom: all rows are alike",
      return c.distance * c.forward + side * c.width / 2 * c.right + c.height / 2 * c.right)
SIDES("C-uu", "d f - w/2 u + h/2 u", "d f + w/2 u + h/2 u",
      "both steps go along u. The vector stays on the vertical line through the middle.",
      "stripes from left to right: all columns are alike",
      return c.distance * c.forward + side * c.width / 2 * c.up + c.height / 2 * c.up)
SIDES("C-fu", "d u - w/2 r + h/2 f", "d u + w/2 r + h/2 f",
      "f points to the plane and u to its top. Here they are swapped.",
      "the scene above the camera",
      return c.distance * c.up + side * c.width / 2 * c.right + c.height / 2 * c.forward)
SIDES("C-fr", "d r - w/2 f + h/2 u", "d r + w/2 f + h/2 u",
      "f points to the plane and r along it. Here they are swapped.", "the scene beside the camera",
      return c.distance * c.right + side * c.width / 2 * c.forward + c.height / 2 * c.up)
SIDES("C-axes", "(-w/2, h/2, d)", "(w/2, h/2, d)",
      "these steps go along the axes of the world. The camera has its own axes: r, u and f.",
      "right for the deck's camera; turning the camera changes nothing",
      return vec3_of(side * c.width / 2, c.height / 2, c.distance))
SIDES("C-plus", "d + f - w/2 r + h/2 u", "d + f + w/2 r + h/2 u",
      "adding a number to a vector adds d to every component of f. To go the distance d along f, "
      "multiply.",
      "the view is off to one side",
      return c.distance + c.forward + side * c.width / 2 * c.right + c.height / 2 * c.up)
SIDES("C-number", "d f - w/2 + h/2", "d f + w/2 + h/2",
      "adding a number to a vector adds it to every component. To move to the side or up, multiply "
      "r or u by the number.",
      "the view is off to one side",
      return c.distance * c.forward + side * c.width / 2 + c.height / 2)
WRONG_LINE(upper_left, "C-ru", "d f - w/2 u + h/2 r",
           "r points across and u points up. Here they are swapped.",
           "mirrored in the diagonal: rows become columns",
           return c.distance * c.forward - c.width / 2 * c.up + c.height / 2 * c.right)
WRONG_LINE(upper_left, "C-corner", "d f + h u",
           "this would be right from the lower left corner, but f reaches the middle of the plane.",
           "the middle of the view in the lower left corner",
           return c.distance * c.forward + c.height * c.up)

// ---- wrong ways to the point 30% across and 10% up ----------------------------------------------

WRONG_LINE(
    across_30_up_10, "C6", "d f + 0.3 w r + 0.1 h u",
    "the steps start from the middle. Across starts at the left edge, and up starts at the bottom.",
    "the middle of the view in the lower left corner",
    return c.distance * c.forward + 0.3 * c.width * c.right + 0.1 * c.height * c.up)
WRONG_LINE(across_30_up_10, "C6-minus", "d f - 0.3 w r - 0.1 h u",
           "30% to the left and 10% down from the middle. Across starts at the left edge, and up "
           "starts at the bottom.",
           "the point too far left and too high",
           return c.distance * c.forward - 0.3 * c.width * c.right - 0.1 * c.height * c.up)
WRONG_LINE(across_30_up_10, "C6-x", "d f + 0.3 w r - 0.4 h u",
           "the height is right, but across starts from the middle instead of the left edge.",
           "the point half a picture too far right",
           return c.distance * c.forward + 0.3 * c.width * c.right - 0.4 * c.height * c.up)
WRONG_LINE(across_30_up_10, "C6-y", "d f - 0.2 w r + 0.1 h u",
           "across is right, but up starts from the middle instead of the bottom.",
           "the point half a picture too high",
           return c.distance * c.forward - 0.2 * c.width * c.right + 0.1 * c.height * c.up)
WRONG_LINE(across_30_up_10, "C6-half", "d f + 0.3 w/2 r + 0.1 h/2 u",
           "30% and 10% of half the plane, from the middle. 30% means 30% of the whole width, "
           "starting at the left edge.",
           "the point right of the middle and above it",
           return c.distance * c.forward + 0.3 * c.width / 2 * c.right + 0.1 * c.height / 2 * c.up)
WRONG_LINE(across_30_up_10, "C6-twice", "d f + (0.3 - 1/2) w/2 r + (0.1 - 1/2) h/2 u",
           "halved twice. After subtracting 1/2 you start from the middle already, and from edge "
           "to edge it is the whole width.",
           "the point only half as far from the middle",
           return c.distance * c.forward + (0.3 - 0.5) * c.width / 2 * c.right +
                  (0.1 - 0.5) * c.height / 2 * c.up)
WRONG_LINE(across_30_up_10, "C6-number", "d f + (0.3 - 1/2) w + (0.1 - 1/2) h",
           "adding a number to a vector adds it to every component. To move across or up, multiply "
           "r or u by the number.",
           "the point off to one side",
           return (0.3 - 0.5) * c.width + (0.1 - 0.5) * c.height + c.distance * c.forward)
WRONG_LINE(across_30_up_10, "C6-swap", "d f - 0.4 w r - 0.2 h u", "this is 10% across and 30% up.",
           "the point too far left and too high", return image_plane_vector(c, 0.1, 0.3))
WRONG_LINE(across_30_up_10, "C6-top", "d f - 0.2 w r + 0.4 h u",
           "this is 10% down from the top; the exercise asks for 10% up from the bottom.",
           "the point near the top: upside down", return image_plane_vector(c, 0.3, 0.9))
WRONG_LINE(across_30_up_10, "C6-right", "d f + 0.2 w r - 0.4 h u",
           "this is 30% from the right edge. Across starts at the left edge.",
           "mirrored: left and right swapped", return image_plane_vector(c, 0.7, 0.1))
WRONG_LINE(across_30_up_10, "C6-both", "d f + 0.2 w r + 0.4 h u",
           "both signs are reversed. This point is as far from the upper right corner as the right "
           "one is from the lower left corner.",
           "turned by 180 degrees", return image_plane_vector(c, 0.7, 0.9))
WRONG_LINE(across_30_up_10, "C6-over", "d f - 0.2 w r + 0.6 h u",
           "up starts at the top edge, so the point is above the plane. Up starts at the bottom.",
           "the point above the picture",
           return upper_left(c) + 0.3 * c.width * c.right + 0.1 * c.height * c.up)
WRONG_LINE(
    across_30_up_10, "C6-unit", "d f - 0.2 r - 0.4 u",
    "30% and 10% of 1, not of the plane. The length of 30% depends on the width of the plane.",
    "right if w = h = 1", return c.distance * c.forward - 0.2 * c.right - 0.4 * c.up)
WRONG_LINE(across_30_up_10, "C6-mixed", "d f + (0.3 - w/2) r + (0.1 - h/2) u",
           "0.3 is a share and w/2 is a length. A share becomes a length only when you multiply it "
           "by one.",
           "right if w = h = 1",
           return c.distance * c.forward + (0.3 - c.width / 2) * c.right +
                  (0.1 - c.height / 2) * c.up)
WRONG_LINE(across_30_up_10, "C6-percent", "d f + 29.5 w r + 9.5 h u",
           "30 times the width and 10 times the height. One percent is a hundredth.",
           "the point far outside the picture", return image_plane_vector(c, 30, 10))
WRONG_LINE(
    across_30_up_10, "C6-int", "d f - w/2 r - h/2 u",
    "this is the lower left corner. In C, 30 / 100 is an integer division, and its result is 0.",
    "the point in the corner", return image_plane_vector(c, 30 / 100, 10 / 100))
WRONG_LINE(across_30_up_10, "C6-same", "d f - 0.2 w r - 0.2 h u",
           "30% in both directions, but up must be 10%.", "the point too high",
           return image_plane_vector(c, 0.3, 0.3))
WRONG_LINE(across_30_up_10, "C6-drawn", "d f - 0.25 h u",
           "this is the end of the deck's red vector, at 50% and 25%. The drawing and the text "
           "differ here: follow the text.",
           "the point in the middle column", return image_plane_vector(c, 0.5, 0.25))
WRONG_LINE(across_30_up_10, "C6-f", "f - 0.2 w r - 0.4 h u",
           "f has length 1, and the plane is not at distance 1: the step ahead is d f.",
           "right if d = 1; if not, a narrower or wider view",
           return c.forward - 0.2 * c.width * c.right - 0.4 * c.height * c.up)
WRONG_LINE(across_30_up_10, "C6-flat", "-0.2 w r - 0.4 h u",
           "the step d f is missing. The vector goes only sideways and never reaches the plane.",
           "blank: the rays go off sideways",
           return -0.2 * c.width * c.right - 0.4 * c.height * c.up)
WRONG_LINE(across_30_up_10, "C6-back", "-d f - 0.2 w r - 0.4 h u",
           "f points ahead, to the plane. This vector goes backwards from the eye.",
           "blank, or the scene behind the camera, mirrored",
           return -c.distance * c.forward - 0.2 * c.width * c.right - 0.4 * c.height * c.up)
WRONG_LINE(
    across_30_up_10, "C6-p", "p + d f - 0.2 w r - 0.4 h u",
    "this is the point itself. The vector from the eye to it does not depend on where the eye is.",
    "right if the eye is at the origin; if not, the view is off to one side",
    return c.origin + image_plane_vector(c, 0.3, 0.1))
WRONG_LINE(across_30_up_10, "C6-minus-p", "d f - 0.2 w r - 0.4 h u - p",
           "the vector starts at the eye already, so do not subtract the eye again.",
           "right if the eye is at the origin; if not, the view is off to one side",
           return image_plane_vector(c, 0.3, 0.1) - c.origin)
WRONG_LINE(across_30_up_10, "C6-w", "d f - 0.2 w r - 0.4 w u",
           "the width is used both times. 10% up is a share of the height.",
           "right if w = h; if not, too low or too high",
           return c.distance * c.forward - 0.2 * c.width * c.right - 0.4 * c.width * c.up)
WRONG_LINE(across_30_up_10, "C6-sizes", "d f - 0.2 h r - 0.4 w u",
           "w is the length along r and h the length along u. Here they are swapped.",
           "right if w = h; if not, squashed or stretched",
           return c.distance * c.forward - 0.2 * c.height * c.right - 0.4 * c.width * c.up)
WRONG_LINE(across_30_up_10, "C6-ru", "d f - 0.2 w u - 0.4 h r",
           "r points across and u points up. Here they are swapped.",
           "mirrored in the diagonal: rows become columns",
           return c.distance * c.forward - 0.2 * c.width * c.up - 0.4 * c.height * c.right)
WRONG_LINE(across_30_up_10, "C6-axes", "(-0.2 w, -0.4 h, d)",
           "these steps go along the axes of the world. The camera has its own axes: r, u and f.",
           "right for the deck's camera; turning the camera changes nothing",
           return vec3_of(-0.2 * c.width, -0.4 * c.height, c.distance))
WRONG_LINE(across_30_up_10, "C6-length", "the unit vector in that direction",
           "the direction is right, but the vector no longer ends on the plane. Its length must be "
           "the distance to the point.",
           "the same picture; only distances along the rays differ",
           return vec3_unit(image_plane_vector(c, 0.3, 0.1)))

// ---- wrong vectors to any place of the image plane: wrong across and up -------------------------

WRONG_LINE(image_plane_vector, "G-middle", "d f + s w r + t h u",
           "the steps start from the middle, but s and t start at the lower left corner. If your "
           "code has 1 / 2: in C that is an integer division, and its result is 0.",
           "the middle of the view in the lower left corner",
           return c.distance * c.forward + s * c.width * c.right + t * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-s", "d f + s w r + (t - 1/2) h u",
           "s starts from the middle here, but it must start at the left edge.",
           "shifted sideways by half a picture",
           return c.distance * c.forward + s * c.width * c.right + (t - 0.5) * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-t", "d f + (s - 1/2) w r + t h u",
           "t starts from the middle here, but it must start at the bottom.",
           "shifted upward by half a picture",
           return c.distance * c.forward + (s - 0.5) * c.width * c.right + t * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-plus", "d f + (s + 1/2) w r + (t + 1/2) h u",
           "here s = t = 0 is the upper right corner. s = t = 1/2 must be straight ahead.",
           "shifted by a whole picture: blank, or the scene beside the view",
           return c.distance * c.forward + (s + 0.5) * c.width * c.right +
                  (t + 0.5) * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-over", "d f + (s - 1/2) w r + (t + 1/2) h u",
           "t starts at the top edge here, but it must start at the bottom.",
           "shifted upward by a whole picture",
           return c.distance * c.forward + (s - 0.5) * c.width * c.right +
                  (t + 0.5) * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-down", "d f + (s - 1/2) w r - (t - 1/2) h u",
           "t grows upward, as u does. Here t = 0 is at the top.", "upside down",
           return c.distance * c.forward + (s - 0.5) * c.width * c.right -
                  (t - 0.5) * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-mirror", "d f - (s - 1/2) w r + (t - 1/2) h u",
           "s grows to the right, as r does. Here s = 0 is at the right edge.",
           "mirrored: left and right swapped",
           return c.distance * c.forward - (s - 0.5) * c.width * c.right +
                  (t - 0.5) * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-turned", "d f - (s - 1/2) w r - (t - 1/2) h u",
           "both signs are reversed. Here s and t start at the upper right corner.",
           "turned by 180 degrees",
           return c.distance * c.forward - (s - 0.5) * c.width * c.right -
                  (t - 0.5) * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-swap", "d f + (t - 1/2) w r + (s - 1/2) h u",
           "s goes across and t goes up. Here they are swapped.",
           "mirrored in the diagonal: rows become columns",
           return c.distance * c.forward + (t - 0.5) * c.width * c.right +
                  (s - 0.5) * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-ru", "d f + (s - 1/2) w u + (t - 1/2) h r",
           "r points across and u points up. Here they are swapped.",
           "mirrored in the diagonal: rows become columns",
           return c.distance * c.forward + (s - 0.5) * c.width * c.up +
                  (t - 0.5) * c.height * c.right)
WRONG_LINE(image_plane_vector, "G-ss", "d f + (s - 1/2) w r + (s - 1/2) h u",
           "s is used for both, so the vector stays on the diagonal of the plane. How far up it "
           "goes is t.",
           "stripes from top to bottom: all rows are alike",
           return c.distance * c.forward + (s - 0.5) * c.width * c.right +
                  (s - 0.5) * c.height * c.up)
WRONG_LINE(
    image_plane_vector, "G-unit", "d f + (s - 1/2) r + (t - 1/2) u",
    "s and t are shares, without a unit. The length of a share depends on the size of the plane.",
    "right if w = h = 1; if not, a narrower or wider view",
    return c.distance * c.forward + (s - 0.5) * c.right + (t - 0.5) * c.up)
WRONG_LINE(image_plane_vector, "G-half", "d f + (s - 1/2) w/2 r + (t - 1/2) h/2 u",
           "halved twice. This goes only half as far across and up as the edges are.",
           "everything at twice its size",
           return c.distance * c.forward + (s - 0.5) * c.width / 2 * c.right +
                  (t - 0.5) * c.height / 2 * c.up)
WRONG_LINE(
    image_plane_vector, "G-twice", "d f + (2 s - 1) w r + (2 t - 1) h u",
    "from -1 to 1 is two widths. From its left edge to its right edge the plane is only w wide.",
    "everything at half its size",
    return c.distance * c.forward + (2 * s - 1) * c.width * c.right + (2 * t - 1) * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-order", "d f + (s w - 1/2) r + (t h - 1/2) u",
           "s w is a length and 1/2 is a share. Subtract half of the plane, not half a unit.",
           "right if w = h = 1; if not, shifted",
           return c.distance * c.forward + (s * c.width - 0.5) * c.right +
                  (t * c.height - 0.5) * c.up)
WRONG_LINE(image_plane_vector, "G-w", "d f + (s - 1/2) w r + (t - 1/2) w u",
           "the width is used both times. t is a share of the height.",
           "right if w = h; if not, squashed or stretched",
           return c.distance * c.forward + (s - 0.5) * c.width * c.right +
                  (t - 0.5) * c.width * c.up)
WRONG_LINE(image_plane_vector, "G-h", "d f + (s - 1/2) h r + (t - 1/2) h u",
           "the height is used both times. s is a share of the width.",
           "right if w = h; if not, squashed or stretched",
           return c.distance * c.forward + (s - 0.5) * c.height * c.right +
                  (t - 0.5) * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-sizes", "d f + (s - 1/2) h r + (t - 1/2) w u",
           "w is the length along r and h the length along u. Here they are swapped.",
           "right if w = h; if not, squashed or stretched",
           return c.distance * c.forward + (s - 0.5) * c.height * c.right +
                  (t - 0.5) * c.width * c.up)

WRONG(image_plane_vector, "G-clamp", "s and t limited to 0..1",
      "beyond the edges the same formula holds; there is no limit.",
      "the same picture; beyond the edges, the edge is repeated")
{
    s = fmin(fmax(s, 0), 1);
    t = fmin(fmax(t, 0), 1);
    return c.distance * c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up;
}

// ---- wrong vectors to any place of the image plane: wrong ahead, or with other directions -------

WRONG_LINE(image_plane_vector, "G-f", "f + (s - 1/2) w r + (t - 1/2) h u",
           "f has length 1, and the plane is not at distance 1: the step ahead is d f.",
           "right if d = 1; if not, a narrower or wider view",
           return c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-flat", "(s - 1/2) w r + (t - 1/2) h u",
           "the step d f is missing. The vector goes only sideways and never reaches the plane.",
           "blank: the rays go off sideways",
           return (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-back", "-d f + (s - 1/2) w r + (t - 1/2) h u",
           "f points ahead, to the plane. This vector goes backwards from the eye.",
           "blank, or the scene behind the camera, mirrored",
           return -c.distance * c.forward + (s - 0.5) * c.width * c.right +
                  (t - 0.5) * c.height * c.up)
WRONG_LINE(image_plane_vector, "G-p", "p + d f + (s - 1/2) w r + (t - 1/2) h u",
           "this is the place as a point of the world. The vector from the eye to it does not "
           "depend on where the eye is.",
           "right if the eye is at the origin; if not, the view is off to one side",
           return c.origin + image_plane_vector(c, s, t))
WRONG_LINE(image_plane_vector, "G-minus-p", "d f + (s - 1/2) w r + (t - 1/2) h u - p",
           "the vector starts at the eye already, so do not subtract the eye again.",
           "right if the eye is at the origin; if not, the view is off to one side",
           return image_plane_vector(c, s, t) - c.origin)
WRONG_LINE(image_plane_vector, "G-times", "d (f + (s - 1/2) w r + (t - 1/2) h u)",
           "the steps across and up are multiplied by d as well. The size of the plane does not "
           "depend on its distance.",
           "right if d = 1; if not, too small or too large",
           return c.distance *
                  (c.forward + (s - 0.5) * c.width * c.right + (t - 0.5) * c.height * c.up))
WRONG_LINE(image_plane_vector, "G-length", "the unit vector in that direction",
           "the direction is right, but the vector no longer ends on the plane. Its length must be "
           "the distance to the point.",
           "the same picture; only distances along the rays differ",
           return vec3_unit(image_plane_vector(c, s, t)))
WRONG_LINE(image_plane_vector, "G-one", "1/d of the vector",
           "the direction is right, but the vector ends at distance 1 and not on the plane.",
           "the same picture; only distances along the rays differ",
           return image_plane_vector(c, s, t) / c.distance)
WRONG_LINE(image_plane_vector, "G-number", "d f + (s - 1/2) w + (t - 1/2) h",
           "adding a number to a vector adds it to every component. To move across or up, multiply "
           "r or u by the number.",
           "stripes: every step goes in the same direction",
           return (s - 0.5) * c.width + (t - 0.5) * c.height + c.distance * c.forward)
WRONG_LINE(image_plane_vector, "G-axes", "((s - 1/2) w, (t - 1/2) h, d)",
           "these steps go along the axes of the world. The camera has its own axes: r, u and f.",
           "right for the deck's camera; turning the camera changes nothing",
           return vec3_of((s - 0.5) * c.width, (t - 0.5) * c.height, c.distance))

// ---- wrong answers to exercise 01: cameras of unit distance, and the list of all tables ---------

// The right answer, for mistakes that change it afterwards.
static Camera width_and_height_divided(Camera c)
{
    c.width /= c.distance;
    c.height /= c.distance;
    return c;
}

WRONG_LINE(with_unit_distance, "D-same", "d, w, h as they were",
           "the camera is returned unchanged. If you changed a copy of it, return the copy.",
           "the same picture, but d is still not 1", return c)

WRONG(with_unit_distance, "D-only", "1, w, h",
      "the plane comes nearer but keeps its size. If you divide after setting d to 1, you divide "
      "by 1.",
      "a wider view if d was more than 1")
{
    c.distance = 1;
    return c;
}

// A camera at distance 1, whose sizes are wrong.
#define UNIT_DISTANCE(id, formula, why, picture, ...)                                              \
    WRONG(with_unit_distance, id, formula, why, picture)                                           \
    {                                                                                              \
        __VA_ARGS__;                                                                               \
        c.distance = 1;                                                                            \
        return c;                                                                                  \
    }

UNIT_DISTANCE(
    "D-w", "1, w/d, h",
    "the height is unchanged, so the plane changes its shape. If you set d to 1 in between, you "
    "divide by 1.",
    "everything squashed if d was more than 1", c.width /= c.distance)
UNIT_DISTANCE("D-h", "1, w, h/d", "the width is unchanged, so the plane changes its shape.",
              "everything narrower if d was more than 1", c.height /= c.distance)

WRONG_LINE(with_unit_distance, "D-left", "d, w/d, h/d",
           "the plane shrinks but stays at its distance. d must become 1.",
           "a narrower view if d was more than 1", return width_and_height_divided(c))

UNIT_DISTANCE("D-times", "1, w d, h d",
              "a plane that comes nearer must shrink to fill the same view; this one grows.",
              "a much wider view if d was more than 1", c.width *= c.distance;
              c.height *= c.distance)
UNIT_DISTANCE("D-over", "1, d/w, d/h",
              "the fractions are upside down. A wider plane would give a narrower view.",
              "another view, of another shape", c.width = c.distance / c.width;
              c.height = c.distance / c.height)
UNIT_DISTANCE(
    "D-half", "1, w/2, h/2",
    "halving is right only if d was 2. How much the plane shrinks depends on its distance.",
    "right if d = 2; if not, a narrower or wider view", c.width /= 2;
    c.height /= 2)

WRONG(with_unit_distance, "D-double", "2 d, 2 w, 2 h",
      "this shows that doubling does not matter; but the exercise asks for the camera with d = 1.",
      "the same picture, but d is not 1")
{
    c.width *= 2;
    c.height *= 2;
    c.distance *= 2;
    return c;
}

UNIT_DISTANCE("D-sizes", "1, h/d, w/d", "w and h are swapped.",
              "right if w = h; if not, squashed or stretched", double width = c.width;
              c.width = c.height / c.distance; c.height = width / c.distance)
UNIT_DISTANCE("D-width", "1, w/d, w/d",
              "the width is used both times. The plane must keep its shape.",
              "right if w = h; if not, squashed or stretched", c.width /= c.distance;
              c.height = c.width)
UNIT_DISTANCE(
    "D-eye", "1, w/d, h/d and p + (d - 1) f",
    "the eye has moved. The same picture is seen from the same eye: only the plane moves.",
    "other objects hide each other; near ones are larger", c = width_and_height_divided(c);
    c.origin += (c.distance - 1) * c.forward)
UNIT_DISTANCE("D-p", "1, w/d, h/d and p/d",
              "the eye has moved. The plane shrinks towards the eye, but the world does not.",
              "right if the eye is at the origin; if not, another view",
              c = width_and_height_divided(c);
              c.origin /= c.distance)
UNIT_DISTANCE("D-f", "1, w/d, h/d and f/d",
              "f is a direction and keeps its length 1. d alone says how far away the plane is.",
              "a wider view if d was more than 1", c = width_and_height_divided(c);
              c.forward /= c.distance)

WRONG(
    with_unit_distance, "D-d-f", "1, w/d, h/d and d f",
    "f is a direction and keeps its length 1. Now the plane is as far away as before, but smaller.",
    "a narrower view if d was more than 1")
{
    c = width_and_height_divided(c);
    c.forward *= c.distance;
    c.distance = 1;
    return c;
}

// Right for some cameras, or for two of the three axes: conditions and limits that their authors
// added, and a forgotten last component.

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

#define SEVEN_DIGITS "a float has 7 digits, and the answer needs 9. Use double."

SIDES("C-float", "the formula in float", "the formula in float", SEVEN_DIGITS,
      "no visible difference, or ragged edges", return rounded_to_float(corner(c, side)))
SIDES("C-z", "x and y right, z = 0", "x and y right, z = 0",
      "a vector has three components, [0], [1] and [2]. The last one is missing.",
      "blank, or a picture from the wrong side", return without_z(corner(c, side)))
WRONG_LINE(across_30_up_10, "C6-float", "the formula in float", SEVEN_DIGITS,
           "no visible difference, or ragged edges",
           return rounded_to_float(image_plane_vector(c, 0.3, 0.1)))
WRONG_LINE(image_plane_vector, "G-float", "the formula in float", SEVEN_DIGITS,
           "no visible difference, or ragged edges",
           return rounded_to_float(image_plane_vector(c, s, t)))
WRONG_LINE(image_plane_vector, "G-z", "x and y right, z = 0",
           "a vector has three components, [0], [1] and [2]. The last one is missing.",
           "blank, or a picture from the wrong side", return without_z(image_plane_vector(c, s, t)))
WRONG_LINE(with_unit_distance, "D-far", "only if d > 1",
           "a plane that is nearer than 1 is moved away in the same way: w and h grow with it.",
           "the same picture, but d is not always 1",
           return c.distance > 1 ? with_unit_distance(c) : c)
WRONG_LINE(
    with_unit_distance, "D-near", "only if d < 1",
    "a plane that is farther than 1 is moved nearer in the same way: w and h shrink with it.",
    "the same picture, but d is not always 1", return c.distance < 1 ? with_unit_distance(c) : c)
