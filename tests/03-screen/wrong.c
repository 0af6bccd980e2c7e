// wrong.c - wrong answers to exercise 03.
#include "exercises/03-screen.h"

#include "tests/judge/known.h"

#include <math.h>

#define SEVEN_DIGITS "a float has 7 digits, and the answer needs more. Use double."
#define EDGES                                                                                      \
    "four pixels have five edges, and from the first edge to the last it is four pixels, not "     \
    "three."

// In the letters of the lesson: a point (x, y) of a screen of W by H pixels, normalized (s, t).
#define PLACE(id, formula, why, picture, across, upward)                                           \
    WRONG(screen_to_normalized, id, formula, why, picture)                                         \
    {                                                                                              \
        LETTER(double, x) = point.x;                                                               \
        LETTER(double, y) = point.y;                                                               \
        LETTER(int, W) = screen.width;                                                             \
        LETTER(int, H) = screen.height;                                                            \
        return (Normalized){across, upward};                                                       \
    }
#define POINT(id, formula, why, picture, ...)                                                      \
    WRONG(normalized_to_screen, id, formula, why, picture)                                         \
    {                                                                                              \
        LETTER(double, s) = normalized.s;                                                          \
        LETTER(double, t) = normalized.t;                                                          \
        LETTER(int, W) = screen.width;                                                             \
        LETTER(int, H) = screen.height;                                                            \
        return (ScreenPoint){__VA_ARGS__};                                                         \
    }
#define CENTER(id, formula, why, picture, across, downward)                                        \
    WRONG(pixel_center, id, formula, why, picture)                                                 \
    {                                                                                              \
        LETTER(int, column) = pixel.column;                                                        \
        LETTER(int, row) = pixel.row;                                                              \
        return (ScreenPoint){across, downward};                                                    \
    }

// ---- wrong conversions from a point of the screen to normalized coordinates ---------------------

PLACE("N1", "(x/W, y/H)",
      "y counts down from the top, t up from the bottom. This is the fraction of the way down.",
      "upside down", x / W, y / H)
PLACE("N2", "x/W and y/H in integers",
      "in C, 300 / 640 is an integer division: its result is 0 for every point on the screen.",
      "one flat color", (int)x / W, 1 - (int)y / H)
PLACE("N3", "(x/(W - 1), 1 - y/(H - 1))", EDGES,
      "everything slightly too small; on a single pixel, nothing", x / (W - 1), 1 - y / (H - 1))
PLACE("N4", "s from y, t from x", "s goes across, as x does, and t goes up. Here they are swapped.",
      "mirrored in the diagonal: rows become columns", 1 - y / H, x / W)
PLACE("N4-N1", "(y/H, x/W)", "s goes across, as x does; and y counts down while t counts up.",
      "turned on its side", y / H, x / W)
PLACE("N6", "(1 - x/W, y/H)",
      "y runs against t, but x does not run against s: both go to the right.",
      "turned by 180 degrees", 1 - x / W, y / H)
PLACE("N6-both", "(1 - x/W, 1 - y/H)",
      "x and s both go to the right, from the same edge. Only the vertical axis is reversed.",
      "mirrored: left and right swapped", 1 - x / W, 1 - y / H)
PLACE("N7", "(2 x/W - 1, 1 - 2 y/H)",
      "this is 0 in the middle and runs from -1 to 1. s and t are 0 at the lower left corner.",
      "shifted, and everything at half its size", 2 * x / W - 1, 1 - 2 * y / H)
PLACE("N7-N1", "(2 x/W - 1, 2 y/H - 1)",
      "this runs from -1 to 1, and downward. s and t are 0 at the lower left corner.",
      "shifted, at half its size and upside down", 2 * x / W - 1, 2 * y / H - 1)
PLACE("N7-half", "(x/W - 1/2, 1/2 - y/H)",
      "this counts from the middle of the screen. s and t are 0 at the lower left corner.",
      "the middle of the view in the upper right corner", x / W - 0.5, 0.5 - y / H)
PLACE("N-sizes", "(x/H, 1 - y/W)", "the screen is W wide and H high. x runs across and y down.",
      "right on a square screen; if not square, squashed and cut off", x / H, 1 - y / W)
PLACE("N-width", "(x/W, 1 - y/W)",
      "W is used for both. From the top of the screen to the bottom it is H pixels.",
      "right on a square screen; if not square, out of shape and shifted", x / W, 1 - y / W)
PLACE("N-height", "(x/H, 1 - y/H)",
      "H is used for both. From the left of the screen to the right it is W pixels.",
      "right on a square screen; if not square, out of shape and shifted", x / H, 1 - y / H)
PLACE("N-xx", "(x/W, 1 - x/W)", "how far up a point is does not depend on x.",
      "stripes from top to bottom: all rows are alike", x / W, 1 - x / W)
PLACE("N-order", "(x/W, (1 - y)/H)",
      "1 is the whole height only after dividing. Before, in pixels, 1 is just one pixel.",
      "the view almost a whole picture too low", x / W, (1 - y) / H)
PLACE("N-minus", "(x/W, y/H - 1)",
      "the subtraction is reversed: t is 1 minus the fraction of the way down, and not below 0 on "
      "the "
      "screen.",
      "upside down, and the view a whole picture too low", x / W, y / H - 1)
PLACE("N-plus", "(x/W, 1 + y/H)",
      "a point further down has a smaller t. Here t is 1 at the top and grows to 2 downward.",
      "upside down, and the view a whole picture too high", x / W, 1 + y / H)
PLACE("N-last", "(x/W, (H - 1 - y)/H)",
      "H - 1 is the number of the last row. A point is continuous: the bottom edge is at y = H.",
      "the view a pixel too low", x / W, (H - 1 - y) / H)
PLACE("N-floor", "x and y truncated to integers",
      "a point may lie anywhere in a pixel. Here all points of a pixel have become its corner.",
      "half a pixel off", floor(x) / W, 1 - floor(y) / H)
PLACE("N-half", "((x + 1/2)/W, 1 - (y + 1/2)/H)",
      "half a pixel is the way from a pixel to its center, and this is a point already.",
      "half a pixel off: added twice", (x + 0.5) / W, 1 - (y + 0.5) / H)
PLACE("N-half-less", "((x - 1/2)/W, 1 - (y - 1/2)/H)",
      "0 is at the edge of the screen, and a point is counted from there already.",
      "half a pixel off", (x - 0.5) / W, 1 - (y - 0.5) / H)
PLACE("N-clamp", "s and t limited to 0..1",
      "a point beyond the screen is beyond 0..1; there is no limit at the edge.",
      "the same picture; beyond the edges, the edge is repeated", fmin(fmax(x / W, 0), 1),
      fmin(fmax(1 - y / H, 0), 1))
PLACE("N-odd", "W/2 and H/2 in integers",
      "in C, 3 / 2 is an integer division, and its result is 1. The middle of a screen may be half "
      "way across a pixel.",
      "right for even sizes; slightly off for odd ones", 0.5 + 0.5 * (x - W / 2) / fmax(W / 2, 1),
      0.5 - 0.5 * (y - H / 2) / fmax(H / 2, 1))
PLACE("N-over", "(W/x, 1 - H/y)",
      "the fractions are upside down. A fraction is the part divided by the whole.",
      "nothing recognisable", W / x, 1 - H / y)
PLACE("N-pixels", "(x, H - y)",
      "reversed, but still in pixels. s and t are fractions of the screen, without a unit.",
      "one flat color: after the first pixel the rays leave the view", x, H - y)

// ---- wrong conversions from normalized coordinates to the point of the screen -------------------

POINT("B1", "(s W, t H)",
      "t counts up from the bottom, y down from the top. This is the height above the bottom.",
      "upside down", .x = s * W, .y = t * H)
POINT(
    "B2", "s and t truncated to integers",
    "the fraction is converted to an integer before the multiplication, and everywhere inside the "
    "screen the result is 0.",
    "every point in the lower left corner", .x = (int)s * W, .y = (1 - (int)t) * H)
POINT("B3", "(s (W - 1), (1 - t) (H - 1))", EDGES,
      "slightly too small: the last column and row stay empty", .x = s * (W - 1),
      .y = (1 - t) * (H - 1))
POINT("B4", "x from t, y from s", "s goes across, as x does, and t goes up. Here they are swapped.",
      "mirrored in the diagonal: rows become columns", .x = (1 - t) * W, .y = s * H)
POINT("B4-B1", "(t W, s H)", "s goes across, as x does; and t counts up while y counts down.",
      "turned on its side", .x = t * W, .y = s * H)
POINT("B6", "((1 - s) W, t H)",
      "t runs against y, but s does not run against x: both go to the right.",
      "turned by 180 degrees", .x = (1 - s) * W, .y = t * H)
POINT("B6-both", "((1 - s) W, (1 - t) H)",
      "s and x both go to the right, from the same edge. Only the vertical axis is reversed.",
      "mirrored: left and right swapped", .x = (1 - s) * W, .y = (1 - t) * H)
POINT("B7", "((s + 1)/2 W, (1 - t)/2 H)",
      "this assumes that s and t run from -1 to 1. They are 0 at the lower left corner and 1 at "
      "the upper right.",
      "everything in the upper right quarter of the screen", .x = (s + 1) / 2 * W,
      .y = (1 - t) / 2 * H)
POINT("B7-half", "((s - 1/2) W, (1/2 - t) H)",
      "this counts from the middle of the screen. x and y are 0 at the upper left corner.",
      "shifted by half a screen", .x = (s - 0.5) * W, .y = (0.5 - t) * H)
POINT("B-sizes", "(s H, (1 - t) W)", "the screen is W wide and H high. s goes across and t up.",
      "right on a square screen; if not square, squashed and cut off", .x = s * H, .y = (1 - t) * W)
POINT("B-width", "(s W, (1 - t) W)",
      "W is used for both. From the top of the screen to the bottom it is H pixels.",
      "right on a square screen; if not square, stretched or squashed", .x = s * W,
      .y = (1 - t) * W)
POINT("B-height", "(s H, (1 - t) H)",
      "H is used for both. From the left of the screen to the right it is W pixels.",
      "right on a square screen; if not square, stretched or squashed", .x = s * H,
      .y = (1 - t) * H)
POINT("B-ss", "(s W, (1 - s) H)", "how far down a point is does not depend on s.",
      "every point on one diagonal", .x = s * W, .y = (1 - s) * H)
POINT("B-order", "(s W, 1 - t H)",
      "1 is the whole height only before multiplying. After it, in pixels, 1 is just one pixel.",
      "everything above the screen", .x = s * W, .y = 1 - t * H)
POINT("B-minus", "(s W, (t - 1) H)",
      "the subtraction is reversed: this is how far below the top the point is, but negative.",
      "everything above the screen, upside down", .x = s * W, .y = (t - 1) * H)
POINT("B-plus", "(s W, (1 + t) H)",
      "a point further up has a smaller y. Here y is a whole height or more.",
      "everything below the screen, upside down", .x = s * W, .y = (1 + t) * H)
POINT("B-last", "(s W, H - 1 - t H)",
      "H - 1 is the number of the last row. A point is continuous: the bottom edge is at y = H.",
      "a pixel too high", .x = s * W, .y = H - 1 - t * H)
POINT("B-floor", "x and y truncated to whole pixels",
      "this is a pixel. A point may lie anywhere between whole numbers.",
      "up to a pixel off, to the left and upward", .x = floor(s * W), .y = floor((1 - t) * H))
POINT("B-round", "x and y rounded to whole pixels",
      "a point may lie anywhere between whole numbers.", "up to half a pixel off",
      .x = round(s * W), .y = round((1 - t) * H))
POINT("B-half", "half a pixel less",
      "half a pixel is the way from a pixel's corner to its center. This point is exactly where s "
      "and t say.",
      "half a pixel off, to the left and upward", .x = s * W - 0.5, .y = (1 - t) * H - 0.5)
POINT("B-half-more", "half a pixel more",
      "half a pixel is the way from a pixel's corner to its center. This point is exactly where s "
      "and t say.",
      "half a pixel off, to the right and downward", .x = s * W + 0.5, .y = (1 - t) * H + 0.5)
POINT("B-clamp", "x and y limited to the screen",
      "a point beyond 0..1 is beyond the screen; there is no limit at the edge.",
      "everything beyond the screen is drawn along its edge", .x = fmin(fmax(s * W, 0), W),
      .y = fmin(fmax((1 - t) * H, 0), H))
POINT("B-divide", "(s/W, (1 - t)/H)",
      "this is the other direction. A fraction becomes pixels when you multiply it by the whole.",
      "every point in the upper left pixel", .x = s / W, .y = (1 - t) / H)

// ---- wrong centers of pixels --------------------------------------------------------------------

CENTER("M-corner", "(column, row)",
       "this is the pixel's upper left corner, which it shares with three other pixels. If your "
       "code has 1 / 2: in C that is an integer division, and its result is 0.",
       "half a pixel off", column, row)
CENTER("M-far", "(column + 1, row + 1)",
       "this is the pixel's lower right corner, across the whole square.",
       "half a pixel off the other way", column + 1, row + 1)
CENTER("M-swap", "(row + 1/2, column + 1/2)",
       "x counts columns, from the left, and y counts rows, from the top.",
       "mirrored in the diagonal: rows become columns", row + 0.5, column + 0.5)
CENTER("M-back", "(column - 1/2, row - 1/2)",
       "the pixel's square starts at (column, row) and extends right and down from there. This is "
       "the center of another pixel.",
       "a whole pixel off, to the left and upward", column - 0.5, row - 0.5)
CENTER("M-up", "(column + 1/2, row - 1/2)",
       "y grows downward, and the square extends down from its row. This is the center of the "
       "pixel above.",
       "a pixel too high", column + 0.5, row - 0.5)
CENTER(
    "M-left", "(column - 1/2, row + 1/2)",
    "the square extends to the right from its column. This is the center of the pixel on the left.",
    "a pixel too far left", column - 0.5, row + 0.5)
CENTER("M-column", "(column + 1/2, row)",
       "this is the middle of the pixel's upper edge. A row also has a height: add half of it.",
       "half a pixel off, upward", column + 0.5, row)
CENTER("M-row", "(column, row + 1/2)",
       "this is the middle of the pixel's left side. A column also has a width: add half of it.",
       "half a pixel off, to the left", column, row + 0.5)
CENTER("M-average", "((column + 1)/2, (row + 1)/2)",
       "the column itself is halved. Only the added pixel is halved: column + 1/2.",
       "only the upper left quarter of the view, at twice its size", (column + 1) / 2.0,
       (row + 1) / 2.0)
CENTER("M-times", "(column/2, row/2)",
       "this is half way from the corner of the screen to the pixel. The center is half a pixel "
       "away from the pixel's own corner.",
       "only the upper left quarter of the view, at twice its size", 0.5 * column, 0.5 * row)
CENTER("M-double", "(2 column + 1, 2 row + 1)",
       "this counts in halves of a pixel. x and y count whole pixels.",
       "everything at half its size, in the upper left quarter", 2 * column + 1, 2 * row + 1)
CENTER("M-cc", "(column + 1/2, column + 1/2)", "how far down a pixel is depends on its row.",
       "stripes from top to bottom: all rows are alike", column + 0.5, column + 0.5)
CENTER("M-down", "(column + 1/2, -(row + 1/2))",
       "y grows downward on the screen, as rows do. The axis is reversed later, in the step to t.",
       "upside down, and the view a whole picture too high", column + 0.5, -(row + 0.5))

// ---- on one axis only, and in float
// --------------------------------------------------------------

PLACE("N3-x", "x/(W - 1)", EDGES, "everything slightly too wide", x / (W - 1), 1 - y / H)
PLACE("N3-y", "y/(H - 1)", EDGES, "everything slightly too high", x / W, 1 - y / (H - 1))
PLACE("N-half-x", "(x + 1/2)/W",
      "x is a point already: add nothing to it. Pixels have centers; pixel_center is for them.",
      "half a pixel off, sideways", (x + 0.5) / W, 1 - y / H)
PLACE("N-half-y", "1 - (y + 1/2)/H",
      "y is a point already: add nothing to it. Pixels have centers; pixel_center is for them.",
      "half a pixel off, up or down", x / W, 1 - (y + 0.5) / H)
PLACE("N2-x", "(int)x/W",
      "in C, 300 / 640 is an integer division, and its result is 0. Your y is right.",
      "stripes from left to right: all columns are alike", (int)x / W, 1 - y / H)
PLACE("N2-y", "1 - (int)y/H",
      "in C, 400 / 480 is an integer division, and its result is 0. Your x is right.",
      "stripes from top to bottom: all rows are alike", x / W, 1 - (int)y / H)
PLACE("N7-x", "s = 2x/W - 1", "s goes from -1 to 1, and t from 0 to 1. Both must go from 0 to 1.",
      "everything at half its width, and shifted", 2 * x / W - 1, 1 - y / H)
PLACE("N7-y", "t = 1 - 2y/H", "t goes from -1 to 1, and s from 0 to 1. Both must go from 0 to 1.",
      "everything at half its height, and shifted", x / W, 1 - 2 * y / H)
PLACE("N-float", "in float", SEVEN_DIGITS, "no visible difference, or ragged edges",
      (float)x / (float)W, 1 - (float)y / (float)H)
POINT("B3-x", "s (W - 1)", EDGES, "everything slightly too narrow", .x = s * (W - 1),
      .y = (1 - t) * H)
POINT("B3-y", "(1 - t)(H - 1)", EDGES, "everything slightly too low", .x = s * W,
      .y = (1 - t) * (H - 1))
POINT("B-float", "in float", SEVEN_DIGITS, "no visible difference, or ragged edges",
      .x = (float)s * (float)W, .y = (1 - (float)t) * (float)H)
CENTER("M-float", "in float",
       "a float has 7 digits: beyond 16777216 it holds only whole numbers, and not even all of "
       "them. Use double.",
       "no visible difference, except in enormous pictures", (float)column + 0.5f,
       (float)row + 0.5f)
