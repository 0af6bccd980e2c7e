// wrong.c - wrong answers to exercise 01.
#include "exercises/01-corners.h"

#include "tests/judge/known.h"

// Steps from the eye: ahead along f, to the right along r, and up along u.
static vec3 steps(Camera c, double ahead, double aside, double above)
{
    return ahead * c.forward + aside * c.right + above * c.up;
}

static vec3 rounded_to_float(vec3 v)
{
    return vec3_of((float)v[0], (float)v[1], (float)v[2]);
}

static vec3 without_z(vec3 v)
{
    return vec3_of(v[0], v[1], 0);
}

// The right answer is steps(c, ahead, aside, above), of which a mistake uses what it likes.
#define LENGTHS(to_the_right, upward)                                                              \
    LETTER(double, ahead) = c.distance;                                                            \
    LETTER(double, aside) = to_the_right;                                                          \
    LETTER(double, above) = upward;

// One slip, two corners: side is -1 for the left corner and 1 for the right one.
#define SIDES(id, left, right, why, picture, vector)                                               \
    WRONG(upper_left, id, left, why, picture)                                                      \
    {                                                                                              \
        const double side = -1;                                                                    \
        LENGTHS(c.width / 2 * side, c.height / 2)                                                  \
        return vector;                                                                             \
    }                                                                                              \
    WRONG(upper_right, id "-right", right, why, picture)                                           \
    {                                                                                              \
        const double side = 1;                                                                     \
        LENGTHS(c.width / 2 * side, c.height / 2)                                                  \
        return vector;                                                                             \
    }
#define ACROSS(id, formula, why, picture, vector)                                                  \
    WRONG(across_30_up_10, id, formula, why, picture)                                              \
    {                                                                                              \
        LENGTHS(-0.2 * c.width, -0.4 * c.height)                                                   \
        return vector;                                                                             \
    }
#define PLACE(id, formula, why, picture, vector)                                                   \
    WRONG(image_plane_vector, id, formula, why, picture)                                           \
    {                                                                                              \
        LENGTHS((s - 0.5) * c.width, (t - 0.5) * c.height)                                         \
        return vector;                                                                             \
    }
// One slip in all four functions: C4 and C4-right, C6-f, G-f.
#define ALL_FOUR(id, name, left, right, across, place, why, picture, vector)                       \
    SIDES(id, left, right, why, picture, vector)                                                   \
    ACROSS("C6-" name, across, why, picture, vector)                                               \
    PLACE("G-" name, place, why, picture, vector)

// ---- wrong upper corners: steps that are too long, too short, or missing ------------------------

SIDES("C1", "d f - w r + h u", "d f + w r + h u",
      "the whole width and height. f reaches the middle of the plane, and each edge is only half "
      "as far from there.",
      "everything at half its size", steps(c, ahead, 2 * aside, 2 * above))
SIDES("C1-w", "d f - w r + h/2 u", "d f + w r + h/2 u",
      "the whole width. f reaches the middle of the plane, and the side is only half the width "
      "away from there.",
      "everything squeezed to half its width", steps(c, ahead, 2 * aside, above))
SIDES("C1-h", "d f - w/2 r + h u", "d f + w/2 r + h u",
      "the whole height. f reaches the middle of the plane, and the top is only half the height "
      "away from there.",
      "everything squeezed to half its height", steps(c, ahead, aside, 2 * above))
SIDES("C1-all", "(d f - w r + h u) / 2", "(d f + w r + h u) / 2",
      "the step ahead is halved too. It stops half way to the plane.",
      "everything at half its size", steps(c, ahead, 2 * aside, 2 * above) / 2)
SIDES("C7", "d f - w/2 r + w/2 u", "d f + w/2 r + w/2 u",
      "the width is used both times. How far the top is from the middle depends on the height.",
      "right if w = h; if not, squashed or stretched", steps(c, ahead, aside, c.width / 2))
SIDES("C7-h", "d f - h/2 r + h/2 u", "d f + h/2 r + h/2 u",
      "the height is used both times. How far the side is from the middle depends on the width.",
      "right if w = h; if not, squashed or stretched", steps(c, ahead, c.height / 2 * side, above))
SIDES("C-top", "d f + h/2 u", "d f + h/2 u",
      "the step along r is missing. This vector ends in the middle of the top edge.",
      "stripes from left to right: all columns are alike", steps(c, ahead, 0, above))
SIDES("C-side", "d f - w/2 r", "d f + w/2 r",
      "the step along u is missing. This vector ends in the middle of the side.",
      "stripes from top to bottom: all rows are alike", steps(c, ahead, aside, 0))
SIDES("C-int", "d f", "d f",
      "only the vector to the middle is left. In C, 1 / 2 is an integer division, and its result "
      "is 0.",
      "one flat color", steps(c, ahead, 1 / 2 * side * c.width, 1 / 2 * c.height))

// ---- wrong upper corners: a step in the wrong direction, or from the wrong point ----------------

SIDES("C2", "d f - w/2 r - h/2 u", "d f + w/2 r - h/2 u",
      "u points up, so this goes down to the bottom edge.", "upside down",
      steps(c, ahead, aside, -above))
SIDES("C3", "d f + w/2 r + h/2 u", "d f - w/2 r + h/2 u",
      "r points to the right. This is the other corner of the top edge.",
      "mirrored: left and right swapped", steps(c, ahead, -aside, above))
SIDES("C2-C3", "d f + w/2 r - h/2 u", "d f - w/2 r - h/2 u",
      "both steps to the side have the wrong sign. This is the opposite corner.",
      "turned by 180 degrees", steps(c, ahead, -aside, -above))
SIDES("C9-all", "-(d f - w/2 r + h/2 u)", "-(d f + w/2 r + h/2 u)",
      "this is the vector back, from the corner to the eye.",
      "blank, or the scene behind the camera, upside down", -steps(c, ahead, aside, above))
SIDES("C-rr", "d f - w/2 r + h/2 r", "d f + w/2 r + h/2 r",
      "both steps go along r. The vector stays at the height of the middle.",
      "stripes from top to bottom: all rows are alike", steps(c, ahead, aside + above, 0))
SIDES("C-uu", "d f - w/2 u + h/2 u", "d f + w/2 u + h/2 u",
      "both steps go along u. The vector stays on the vertical line through the middle.",
      "stripes from left to right: all columns are alike", steps(c, ahead, 0, aside + above))
SIDES("C-fu", "d u - w/2 r + h/2 f", "d u + w/2 r + h/2 f",
      "f points to the plane and u to its top. Here they are swapped.",
      "the scene above the camera", steps(c, above, aside, ahead))
SIDES("C-fr", "d r - w/2 f + h/2 u", "d r + w/2 f + h/2 u",
      "f points to the plane and r along it. Here they are swapped.", "the scene beside the camera",
      steps(c, aside, ahead, above))
SIDES("C-plus", "d + f - w/2 r + h/2 u", "d + f + w/2 r + h/2 u",
      "adding a number to a vector adds d to every component of f. To go the distance d along f, "
      "multiply.",
      "the view is off to one side", c.distance + steps(c, 1, aside, above))
SIDES("C-number", "d f - w/2 + h/2", "d f + w/2 + h/2",
      "adding a number to a vector adds it to every component. To move to the side or up, multiply "
      "r or u by the number.",
      "the view is off to one side", steps(c, ahead, 0, 0) + aside + above)
#define ACROSS_AND_UP_SWAPPED "r points across and u points up. Here they are swapped."
#define DIAGONAL "mirrored in the diagonal: rows become columns"
WRONG_LINE(upper_left, "C-ru", "d f - w/2 u + h/2 r", ACROSS_AND_UP_SWAPPED, DIAGONAL,
           return steps(c, c.distance, c.height / 2, -c.width / 2))
WRONG_LINE(upper_left, "C-corner", "d f + h u",
           "this would be right from the lower left corner, but f reaches the middle of the plane.",
           "the middle of the view in the lower left corner",
           return steps(c, c.distance, 0, c.height))

// ---- wrong ways to the point 30% across and 10% up ----------------------------------------------

ACROSS(
    "C6", "d f + 0.3 w r + 0.1 h u",
    "the steps start from the middle. Across starts at the left edge, and up starts at the bottom.",
    "the middle of the view in the lower left corner",
    steps(c, ahead, 0.3 * c.width, 0.1 * c.height))
ACROSS("C6-minus", "d f - 0.3 w r - 0.1 h u",
       "30% to the left and 10% down from the middle. Across starts at the left edge, and up "
       "starts at the bottom.",
       "the point too far left and too high", steps(c, ahead, -0.3 * c.width, -0.1 * c.height))
ACROSS("C6-x", "d f + 0.3 w r - 0.4 h u",
       "the height is right, but across starts from the middle instead of the left edge.",
       "the point half a picture too far right", steps(c, ahead, 0.3 * c.width, above))
ACROSS("C6-y", "d f - 0.2 w r + 0.1 h u",
       "across is right, but up starts from the middle instead of the bottom.",
       "the point half a picture too high", steps(c, ahead, aside, 0.1 * c.height))
ACROSS("C6-half", "d f + 0.3 w/2 r + 0.1 h/2 u",
       "30% and 10% of half the plane, from the middle. 30% means 30% of the whole width, starting "
       "at the left edge.",
       "the point right of the middle and above it",
       steps(c, ahead, 0.3 * c.width / 2, 0.1 * c.height / 2))
ACROSS("C6-twice", "d f + (0.3 - 1/2) w/2 r + (0.1 - 1/2) h/2 u",
       "halved twice. After subtracting 1/2 you start from the middle already, and from edge to "
       "edge it is the whole width.",
       "the point only half as far from the middle", steps(c, ahead, aside / 2, above / 2))
ACROSS("C6-number", "d f + (0.3 - 1/2) w + (0.1 - 1/2) h",
       "adding a number to a vector adds it to every component. To move across or up, multiply r "
       "or u by the number.",
       "the point off to one side", steps(c, ahead, 0, 0) + aside + above)
ACROSS("C6-swap", "d f - 0.4 w r - 0.2 h u", "this is 10% across and 30% up.",
       "the point too far left and too high", image_plane_vector(c, 0.1, 0.3))
ACROSS("C6-top", "d f - 0.2 w r + 0.4 h u",
       "this is 10% down from the top; the exercise asks for 10% up from the bottom.",
       "the point near the top: upside down", steps(c, ahead, aside, -above))
ACROSS("C6-right", "d f + 0.2 w r - 0.4 h u",
       "this is 30% from the right edge. Across starts at the left edge.",
       "mirrored: left and right swapped", steps(c, ahead, -aside, above))
ACROSS("C6-both", "d f + 0.2 w r + 0.4 h u",
       "both signs are reversed. This point is as far from the upper right corner as the right one "
       "is from the lower left corner.",
       "turned by 180 degrees", steps(c, ahead, -aside, -above))
ACROSS("C6-over", "d f - 0.2 w r + 0.6 h u",
       "up starts at the top edge, so the point is above the plane. Up starts at the bottom.",
       "the point above the picture", steps(c, ahead, aside, above + c.height))
ACROSS("C6-unit", "d f - 0.2 r - 0.4 u",
       "30% and 10% of 1, not of the plane. The length of 30% depends on the width of the plane.",
       "right if w = h = 1", steps(c, ahead, -0.2, -0.4))
ACROSS("C6-mixed", "d f + (0.3 - w/2) r + (0.1 - h/2) u",
       "0.3 is a fraction and w/2 is a length. A fraction becomes a length only when you multiply "
       "it by "
       "one.",
       "right if w = h = 1", steps(c, ahead, 0.3 - c.width / 2, 0.1 - c.height / 2))
ACROSS("C6-percent", "d f + 29.5 w r + 9.5 h u",
       "30 times the width and 10 times the height. One percent is a hundredth.",
       "the point far outside the picture", image_plane_vector(c, 30, 10))
ACROSS("C6-int", "d f - w/2 r - h/2 u",
       "this is the lower left corner. In C, 30 / 100 is an integer division, and its result is 0.",
       "the point in the corner", image_plane_vector(c, 30 / 100, 10 / 100))
ACROSS("C6-same", "d f - 0.2 w r - 0.2 h u", "30% in both directions, but up must be 10%.",
       "the point too high", image_plane_vector(c, 0.3, 0.3))
ACROSS("C6-drawn", "d f - 0.25 h u",
       "this is the end of the deck's red vector, at 50% and 25%. The drawing and the text differ "
       "here: follow the text.",
       "the point in the middle column", image_plane_vector(c, 0.5, 0.25))
ACROSS("C6-w", "d f - 0.2 w r - 0.4 w u",
       "the width is used both times. 10% up is a fraction of the height.",
       "right if w = h; if not, too low or too high", steps(c, ahead, aside, 2 * aside))
ACROSS("C6-ru", "d f - 0.2 w u - 0.4 h r", ACROSS_AND_UP_SWAPPED, DIAGONAL,
       steps(c, ahead, above, aside))

// ---- wrong vectors to any place of the image plane ----------------------------------------------

PLACE("G-middle", "d f + s w r + t h u",
      "the steps start from the middle, but s and t start at the lower left corner. If your code "
      "has 1 / 2: in C that is an integer division, and its result is 0.",
      "the middle of the view in the lower left corner",
      steps(c, ahead, aside + c.width / 2, above + c.height / 2))
PLACE("G-s", "d f + s w r + (t - 1/2) h u",
      "s starts from the middle here, but it must start at the left edge.",
      "shifted sideways by half a picture", steps(c, ahead, aside + c.width / 2, above))
PLACE("G-t", "d f + (s - 1/2) w r + t h u",
      "t starts from the middle here, but it must start at the bottom.",
      "shifted upward by half a picture", steps(c, ahead, aside, above + c.height / 2))
PLACE("G-plus", "d f + (s + 1/2) w r + (t + 1/2) h u",
      "here s = t = 0 is the upper right corner. s = t = 1/2 must be straight ahead.",
      "shifted by a whole picture: blank, or the scene beside the view",
      steps(c, ahead, aside + c.width, above + c.height))
PLACE("G-over", "d f + (s - 1/2) w r + (t + 1/2) h u",
      "t starts at the top edge here, but it must start at the bottom.",
      "shifted upward by a whole picture", steps(c, ahead, aside, above + c.height))
PLACE("G-down", "d f + (s - 1/2) w r - (t - 1/2) h u",
      "t grows upward, as u does. Here t = 0 is at the top.", "upside down",
      steps(c, ahead, aside, -above))
PLACE("G-mirror", "d f - (s - 1/2) w r + (t - 1/2) h u",
      "s grows to the right, as r does. Here s = 0 is at the right edge.",
      "mirrored: left and right swapped", steps(c, ahead, -aside, above))
PLACE("G-turned", "d f - (s - 1/2) w r - (t - 1/2) h u",
      "both signs are reversed. Here s and t start at the upper right corner.",
      "turned by 180 degrees", steps(c, ahead, -aside, -above))
PLACE("G-swap", "d f + (t - 1/2) w r + (s - 1/2) h u",
      "s goes across and t goes up. Here they are swapped.", DIAGONAL,
      steps(c, ahead, (t - 0.5) * c.width, (s - 0.5) * c.height))
PLACE("G-ru", "d f + (s - 1/2) w u + (t - 1/2) h r", ACROSS_AND_UP_SWAPPED, DIAGONAL,
      steps(c, ahead, above, aside))
PLACE("G-ss", "d f + (s - 1/2) w r + (s - 1/2) h u",
      "s is used for both, so the vector stays on the diagonal of the plane. How far up it goes is "
      "t.",
      "stripes from top to bottom: all rows are alike",
      steps(c, ahead, aside, (s - 0.5) * c.height))
PLACE("G-unit", "d f + (s - 1/2) r + (t - 1/2) u",
      "s and t are fractions, without a unit. The length of a fraction depends on the size of the "
      "plane.",
      "right if w = h = 1; if not, a narrower or wider view", steps(c, ahead, s - 0.5, t - 0.5))
PLACE("G-half", "d f + (s - 1/2) w/2 r + (t - 1/2) h/2 u",
      "halved twice. This goes only half as far across and up as the edges are.",
      "everything at twice its size", steps(c, ahead, aside / 2, above / 2))
PLACE("G-twice", "d f + (2 s - 1) w r + (2 t - 1) h u",
      "from -1 to 1 is two widths. From its left edge to its right edge the plane is only w wide.",
      "everything at half its size", steps(c, ahead, 2 * aside, 2 * above))
PLACE("G-order", "d f + (s w - 1/2) r + (t h - 1/2) u",
      "s w is a length and 1/2 is a fraction. Subtract half of the plane, not half a unit.",
      "right if w = h = 1; if not, shifted",
      steps(c, ahead, aside + c.width / 2 - 0.5, above + c.height / 2 - 0.5))
PLACE("G-w", "d f + (s - 1/2) w r + (t - 1/2) w u",
      "the width is used both times. t is a fraction of the height.",
      "right if w = h; if not, squashed or stretched", steps(c, ahead, aside, (t - 0.5) * c.width))
PLACE("G-h", "d f + (s - 1/2) h r + (t - 1/2) h u",
      "the height is used both times. s is a fraction of the width.",
      "right if w = h; if not, squashed or stretched", steps(c, ahead, (s - 0.5) * c.height, above))
PLACE("G-clamp", "s and t limited to 0..1",
      "beyond the edges the same formula holds; there is no limit.",
      "the same picture; beyond the edges, the edge is repeated",
      image_plane_vector(c, fmin(fmax(s, 0), 1), fmin(fmax(t, 0), 1)))
PLACE("G-number", "d f + (s - 1/2) w + (t - 1/2) h",
      "adding a number to a vector adds it to every component. To move across or up, multiply r or "
      "u by the number.",
      "stripes: every step goes in the same direction", steps(c, ahead, 0, 0) + aside + above)

// ---- the same mistake in all functions ----------------------------------------------------------

ALL_FOUR("C4", "f", "f - w/2 r + h/2 u", "f + w/2 r + h/2 u", "f - 0.2 w r - 0.4 h u",
         "f + (s - 1/2) w r + (t - 1/2) h u",
         "f has length 1, and the plane is not at distance 1: the step ahead is d f.",
         "right if d = 1; if not, a narrower or wider view", steps(c, 1, aside, above))
ALL_FOUR("C4-flat", "flat", "-w/2 r + h/2 u", "w/2 r + h/2 u", "-0.2 w r - 0.4 h u",
         "(s - 1/2) w r + (t - 1/2) h u",
         "the step d f is missing. The vector goes only sideways and never reaches the plane.",
         "blank: the rays go off sideways", steps(c, 0, aside, above))
ALL_FOUR("C9", "back", "-d f - w/2 r + h/2 u", "-d f + w/2 r + h/2 u", "-d f - 0.2 w r - 0.4 h u",
         "-d f + (s - 1/2) w r + (t - 1/2) h u",
         "f points ahead, to the plane. This vector goes backwards from the eye.",
         "blank, or the scene behind the camera, mirrored", steps(c, -ahead, aside, above))
ALL_FOUR("C5", "p", "p + d f - w/2 r + h/2 u", "p + d f + w/2 r + h/2 u",
         "p + d f - 0.2 w r - 0.4 h u", "p + d f + (s - 1/2) w r + (t - 1/2) h u",
         "this is a point of the world. The vector from the eye to it does not depend on where the "
         "eye is.",
         "right if the eye is at the origin; if not, the view is off to one side",
         c.origin + steps(c, ahead, aside, above))
ALL_FOUR("C5-minus", "minus-p", "d f - w/2 r + h/2 u - p", "d f + w/2 r + h/2 u - p",
         "d f - 0.2 w r - 0.4 h u - p", "d f + (s - 1/2) w r + (t - 1/2) h u - p",
         "the vector starts at the eye already, so do not subtract the eye again. p is subtracted "
         "from points, not from vectors.",
         "right if the eye is at the origin; if not, the view is off to one side",
         steps(c, ahead, aside, above) - c.origin)
ALL_FOUR("C-times", "times", "d (f - w/2 r + h/2 u)", "d (f + w/2 r + h/2 u)",
         "d (f - 0.2 w r - 0.4 h u)", "d (f + (s - 1/2) w r + (t - 1/2) h u)",
         "the steps across and up are multiplied by d as well. The size of the plane does not "
         "depend on its distance.",
         "right if d = 1; if not, too small or too large", steps(c, 1, aside, above) * c.distance)
ALL_FOUR("C-one", "one", "f - w/(2d) r + h/(2d) u", "f + w/(2d) r + h/(2d) u", "1/d of the vector",
         "1/d of the vector",
         "the direction is right, but the vector ends at distance 1 and not on the plane.",
         "the same picture; only distances along the rays differ",
         steps(c, ahead, aside, above) / c.distance)
#define UNIT_VECTOR "the unit vector in that direction"
ALL_FOUR("C-unit", "length", UNIT_VECTOR, UNIT_VECTOR, UNIT_VECTOR, UNIT_VECTOR,
         "the direction is right, but the vector no longer ends on the plane. Its length must be "
         "the distance to the point.",
         "the same picture; only distances along the rays differ",
         vec3_unit(steps(c, ahead, aside, above)))
ALL_FOUR("C7-swap", "sizes", "d f - h/2 r + w/2 u", "d f + h/2 r + w/2 u",
         "d f - 0.2 h r - 0.4 w u", "d f + (s - 1/2) h r + (t - 1/2) w u",
         "w is the length along r and h the length along u. Here they are swapped.",
         "right if w = h; if not, squashed or stretched",
         steps(c, ahead, aside / c.width * c.height, above / c.height * c.width))
ALL_FOUR("C-axes", "axes", "(-w/2, h/2, d)", "(w/2, h/2, d)", "(-0.2 w, -0.4 h, d)",
         "((s - 1/2) w, (t - 1/2) h, d)",
         "these steps go along the axes of the world. The camera has its own axes: r, u and f.",
         "right for the deck's camera; turning the camera changes nothing",
         vec3_of(aside, above, ahead))
#define FLOAT "the formula in float"
ALL_FOUR("C-float", "float", FLOAT, FLOAT, FLOAT, FLOAT,
         "a float has 7 digits, and the answer needs 9. Use double.",
         "no visible difference, or ragged edges", rounded_to_float(steps(c, ahead, aside, above)))
#define NO_Z "x and y right, z = 0"
ALL_FOUR("C-z", "z", NO_Z, NO_Z, NO_Z, NO_Z,
         "a vector has three components, [0], [1] and [2]. The last one is missing.",
         "blank, or a picture from the wrong side", without_z(steps(c, ahead, aside, above)))

// ---- wrong cameras of unit distance -------------------------------------------------------------

// The right camera, with a change.
#define CAMERA(id, formula, why, picture, ...)                                                     \
    WRONG(with_unit_distance, id, formula, why, picture)                                           \
    {                                                                                              \
        Camera to = with_unit_distance(c);                                                         \
        __VA_ARGS__;                                                                               \
        return to;                                                                                 \
    }

CAMERA("D-same", "d, w, h as they were",
       "the camera is returned unchanged. If you changed a copy of it, return the copy.",
       "the same picture, but d is still not 1", to = c)
CAMERA("D-only", "1, w, h",
       "the plane comes nearer but keeps its size. If you divide after setting d to 1, you divide "
       "by 1.",
       "a wider view if d was more than 1", to.width = c.width, to.height = c.height)
CAMERA("D-w", "1, w/d, h",
       "the height is unchanged, so the plane changes its shape. If you set d to 1 in between, you "
       "divide by 1.",
       "everything squashed if d was more than 1", to.height = c.height)
CAMERA("D-h", "1, w, h/d", "the width is unchanged, so the plane changes its shape.",
       "everything narrower if d was more than 1", to.width = c.width)
CAMERA("D-left", "d, w/d, h/d", "the plane shrinks but stays at its distance. d must become 1.",
       "a narrower view if d was more than 1", to.distance = c.distance)
CAMERA("D-times", "1, w d, h d",
       "a plane that comes nearer must shrink to fill the same view; this one grows.",
       "a much wider view if d was more than 1", to.width = c.width * c.distance,
       to.height = c.height * c.distance)
CAMERA("D-over", "1, d/w, d/h",
       "the fractions are upside down. A wider plane would give a narrower view.",
       "another view, of another shape", to.width = c.distance / c.width,
       to.height = c.distance / c.height)
CAMERA("D-half", "1, w/2, h/2",
       "halving is right only if d was 2. How much the plane shrinks depends on its distance.",
       "right if d = 2; if not, a narrower or wider view", to.width = c.width / 2,
       to.height = c.height / 2)
CAMERA("D-double", "2 d, 2 w, 2 h",
       "this shows that doubling does not matter; but the exercise asks for the camera with d = 1.",
       "the same picture, but d is not 1", to.distance = 2 * c.distance, to.width = 2 * c.width,
       to.height = 2 * c.height)
CAMERA("D-sizes", "1, h/d, w/d", "w and h are swapped.",
       "right if w = h; if not, squashed or stretched", to.width = c.height / c.distance,
       to.height = c.width / c.distance)
CAMERA("D-width", "1, w/d, w/d", "the width is used both times. The plane must keep its shape.",
       "right if w = h; if not, squashed or stretched", to.height = to.width)
CAMERA("D-eye", "1, w/d, h/d and p + (d - 1) f",
       "the eye has moved. The same picture is seen from the same eye: only the plane moves.",
       "other objects hide each other; near ones are larger",
       to.origin += (c.distance - 1) * c.forward)
CAMERA("D-p", "1, w/d, h/d and p/d",
       "the eye has moved. The plane shrinks towards the eye, but the world does not.",
       "right if the eye is at the origin; if not, another view", to.origin /= c.distance)
CAMERA("D-f", "1, w/d, h/d and f/d",
       "f is a direction and keeps its length 1. d alone says how far away the plane is.",
       "a wider view if d was more than 1", to.forward /= c.distance)
CAMERA(
    "D-d-f", "1, w/d, h/d and d f",
    "f is a direction and keeps its length 1. Now the plane is as far away as before, but smaller.",
    "a narrower view if d was more than 1", to.forward *= c.distance)
CAMERA("D-far", "only if d > 1",
       "a plane that is nearer than 1 is moved away in the same way: w and h grow with it.",
       "the same picture, but d is not always 1", to = c.distance > 1 ? to : c)
CAMERA("D-near", "only if d < 1",
       "a plane that is farther than 1 is moved nearer in the same way: w and h shrink with it.",
       "the same picture, but d is not always 1", to = c.distance < 1 ? to : c)
