// wrong.c - wrong answers to exercise 03.
#include "exercises/03-screen.h"

#include "tests/judge/known.h"

#include <math.h>

// ---- wrong conversions from a point of the screen to normalized coordinates ---------------------

WRONG_LINE(screen_to_normalized, "N1", "(x/W, y/H)",
           "y counts down from the top, t up from the bottom. This is the share of the way down.",
           "upside down", return (Normalized){point.x / screen.width, point.y / screen.height})

WRONG(screen_to_normalized, "N2", "x/W and y/H in integers",
      "in C, 300 / 640 is an integer division: its result is 0 for every point on the screen.",
      "one flat colour")
{
    int x = (int)point.x, y = (int)point.y;
    return (Normalized){x / screen.width, 1 - y / screen.height};
}

WRONG_LINE(screen_to_normalized, "N3", "(x/(W - 1), 1 - y/(H - 1))",
           "four pixels have five edges, and from the first edge to the last it is four pixels, "
           "not three.",
           "everything slightly too small; on a single pixel, nothing",
           return (Normalized){point.x / (screen.width - 1), 1 - point.y / (screen.height - 1)})
WRONG_LINE(screen_to_normalized, "N4", "s from y, t from x",
           "s goes across, as x does, and t goes up. Here they are swapped.",
           "mirrored in the diagonal: rows become columns",
           return (Normalized){1 - point.y / screen.height, point.x / screen.width})
WRONG_LINE(screen_to_normalized, "N4-N1", "(y/H, x/W)",
           "s goes across, as x does; and y counts down while t counts up.", "turned on its side",
           return (Normalized){point.y / screen.height, point.x / screen.width})
WRONG_LINE(screen_to_normalized, "N6", "(1 - x/W, y/H)",
           "y runs against t, but x does not run against s: both go to the right.",
           "turned by 180 degrees",
           return (Normalized){1 - point.x / screen.width, point.y / screen.height})
WRONG_LINE(screen_to_normalized, "N6-both", "(1 - x/W, 1 - y/H)",
           "x and s both go to the right, from the same edge. Only the vertical axis is reversed.",
           "mirrored: left and right swapped",
           return (Normalized){1 - point.x / screen.width, 1 - point.y / screen.height})
WRONG_LINE(screen_to_normalized, "N7", "(2 x/W - 1, 1 - 2 y/H)",
           "this is 0 in the middle and runs from -1 to 1. s and t are 0 at the lower left corner.",
           "shifted, and everything at half its size",
           return (Normalized){2 * point.x / screen.width - 1, 1 - 2 * point.y / screen.height})
WRONG_LINE(screen_to_normalized, "N7-N1", "(2 x/W - 1, 2 y/H - 1)",
           "this runs from -1 to 1, and downward. s and t are 0 at the lower left corner.",
           "shifted, at half its size and upside down",
           return (Normalized){2 * point.x / screen.width - 1, 2 * point.y / screen.height - 1})
WRONG_LINE(screen_to_normalized, "N7-half", "(x/W - 1/2, 1/2 - y/H)",
           "this counts from the middle of the screen. s and t are 0 at the lower left corner.",
           "the middle of the view in the upper right corner",
           return (Normalized){point.x / screen.width - 0.5, 0.5 - point.y / screen.height})
WRONG_LINE(screen_to_normalized, "N-sizes", "(x/H, 1 - y/W)",
           "the screen is W wide and H high. x runs across and y down.",
           "right on a square screen; if not square, squashed and cut off",
           return (Normalized){point.x / screen.height, 1 - point.y / screen.width})
WRONG_LINE(screen_to_normalized, "N-width", "(x/W, 1 - y/W)",
           "W is used for both. From the top of the screen to the bottom it is H pixels.",
           "right on a square screen; if not square, out of shape and shifted",
           return (Normalized){point.x / screen.width, 1 - point.y / screen.width})
WRONG_LINE(screen_to_normalized, "N-height", "(x/H, 1 - y/H)",
           "H is used for both. From the left of the screen to the right it is W pixels.",
           "right on a square screen; if not square, out of shape and shifted",
           return (Normalized){point.x / screen.height, 1 - point.y / screen.height})
WRONG_LINE(screen_to_normalized, "N-xx", "(x/W, 1 - x/W)",
           "how far up a point is does not depend on x.",
           "stripes from top to bottom: all rows are alike",
           return (Normalized){point.x / screen.width, 1 - point.x / screen.width})
WRONG_LINE(screen_to_normalized, "N-order", "(x/W, (1 - y)/H)",
           "1 is the whole height only after dividing. Before, in pixels, 1 is just one pixel.",
           "the view almost a whole picture too low",
           return (Normalized){point.x / screen.width, (1 - point.y) / screen.height})
WRONG_LINE(screen_to_normalized, "N-minus", "(x/W, y/H - 1)",
           "the subtraction is reversed: t is 1 minus the share of the way down, and not below 0 "
           "on the screen.",
           "upside down, and the view a whole picture too low",
           return (Normalized){point.x / screen.width, point.y / screen.height - 1})
WRONG_LINE(screen_to_normalized, "N-plus", "(x/W, 1 + y/H)",
           "a point further down has a smaller t. Here t is 1 at the top and grows to 2 downward.",
           "upside down, and the view a whole picture too high",
           return (Normalized){point.x / screen.width, 1 + point.y / screen.height})
WRONG_LINE(
    screen_to_normalized, "N-last", "(x/W, (H - 1 - y)/H)",
    "H - 1 is the number of the last row. A point is continuous: the bottom edge is at y = H.",
    "the view a pixel too low",
    return (Normalized){point.x / screen.width, (screen.height - 1 - point.y) / screen.height})
WRONG_LINE(
    screen_to_normalized, "N-floor", "x and y truncated to integers",
    "a point may lie anywhere in a pixel. Here all points of a pixel have become its corner.",
    "half a pixel off",
    return (Normalized){floor(point.x) / screen.width, 1 - floor(point.y) / screen.height})
WRONG_LINE(screen_to_normalized, "N-half", "((x + 1/2)/W, 1 - (y + 1/2)/H)",
           "half a pixel is the way from a pixel to its centre, and this is a point already.",
           "half a pixel off: added twice",
           return (Normalized){(point.x + 0.5) / screen.width, 1 - (point.y + 0.5) / screen.height})
WRONG_LINE(screen_to_normalized, "N-half-less", "((x - 1/2)/W, 1 - (y - 1/2)/H)",
           "0 is at the edge of the screen, and a point is counted from there already.",
           "half a pixel off",
           return (Normalized){(point.x - 0.5) / screen.width, 1 - (point.y - 0.5) / screen.height})

WRONG(screen_to_normalized, "N-clamp", "s and t limited to 0..1",
      "a point beyond the screen is beyond 0..1; there is no limit at the edge.",
      "the same picture; beyond the edges, the edge is repeated")
{
    double s = point.x / screen.width, t = 1 - point.y / screen.height;
    return (Normalized){fmin(fmax(s, 0), 1), fmin(fmax(t, 0), 1)};
}

WRONG(screen_to_normalized, "N-odd", "W/2 and H/2 in integers",
      "in C, 3 / 2 is an integer division, and its result is 1. The middle of a screen may be half "
      "way across a pixel.",
      "right for even sizes; slightly off for odd ones")
{
    int half_width = screen.width / 2, half_height = screen.height / 2;
    return (Normalized){0.5 + 0.5 * (point.x - half_width) / fmax(half_width, 1),
                        0.5 - 0.5 * (point.y - half_height) / fmax(half_height, 1)};
}

WRONG_LINE(screen_to_normalized, "N-over", "(W/x, 1 - H/y)",
           "the fractions are upside down. A share is the part divided by the whole.",
           "nothing recognisable",
           return (Normalized){screen.width / point.x, 1 - screen.height / point.y})
WRONG_LINE(screen_to_normalized, "N-pixels", "(x, H - y)",
           "reversed, but still in pixels. s and t are shares of the screen, without a unit.",
           "one flat colour: after the first pixel the rays leave the view",
           return (Normalized){point.x, screen.height - point.y})

// ---- wrong conversions from normalized coordinates to the point of the screen -------------------

WRONG_LINE(normalized_to_screen, "B1", "(s W, t H)",
           "t counts up from the bottom, y down from the top. This is the height above the bottom.",
           "upside down",
           return (ScreenPoint){.x = place.s * screen.width, .y = place.t * screen.height})
WRONG_LINE(normalized_to_screen, "B2", "s and t truncated to integers",
           "the share is converted to an integer before the multiplication, and everywhere inside "
           "the screen the result is 0.",
           "every point in the lower left corner",
           return (ScreenPoint){(int)place.s * screen.width, (1 - (int)place.t) * screen.height})
WRONG_LINE(normalized_to_screen, "B3", "(s (W - 1), (1 - t) (H - 1))",
           "four pixels have five edges, and from the first edge to the last it is four pixels, "
           "not three.",
           "slightly too small: the last column and row stay empty",
           return (ScreenPoint){place.s * (screen.width - 1), (1 - place.t) * (screen.height - 1)})
WRONG_LINE(normalized_to_screen, "B4", "x from t, y from s",
           "s goes across, as x does, and t goes up. Here they are swapped.",
           "mirrored in the diagonal: rows become columns",
           return (ScreenPoint){.x = (1 - place.t) * screen.width, .y = place.s * screen.height})
WRONG_LINE(normalized_to_screen, "B4-B1", "(t W, s H)",
           "s goes across, as x does; and t counts up while y counts down.", "turned on its side",
           return (ScreenPoint){.x = place.t * screen.width, .y = place.s * screen.height})
WRONG_LINE(normalized_to_screen, "B6", "((1 - s) W, t H)",
           "t runs against y, but s does not run against x: both go to the right.",
           "turned by 180 degrees",
           return (ScreenPoint){.x = (1 - place.s) * screen.width, .y = place.t * screen.height})
WRONG_LINE(normalized_to_screen, "B6-both", "((1 - s) W, (1 - t) H)",
           "s and x both go to the right, from the same edge. Only the vertical axis is reversed.",
           "mirrored: left and right swapped",
           return (ScreenPoint){(1 - place.s) * screen.width, (1 - place.t) * screen.height})
WRONG_LINE(normalized_to_screen, "B7", "((s + 1)/2 W, (1 - t)/2 H)",
           "this assumes that s and t run from -1 to 1. They are 0 at the lower left corner and 1 "
           "at the upper right.",
           "everything in the upper right quarter of the screen",
           return (ScreenPoint){(place.s + 1) / 2 * screen.width,
                                (1 - place.t) / 2 * screen.height})
WRONG_LINE(normalized_to_screen, "B7-half", "((s - 1/2) W, (1/2 - t) H)",
           "this counts from the middle of the screen. x and y are 0 at the upper left corner.",
           "shifted by half a screen",
           return (ScreenPoint){(place.s - 0.5) * screen.width, (0.5 - place.t) * screen.height})
WRONG_LINE(normalized_to_screen, "B-sizes", "(s H, (1 - t) W)",
           "the screen is W wide and H high. s goes across and t up.",
           "right on a square screen; if not square, squashed and cut off",
           return (ScreenPoint){place.s * screen.height, (1 - place.t) * screen.width})
WRONG_LINE(normalized_to_screen, "B-width", "(s W, (1 - t) W)",
           "W is used for both. From the top of the screen to the bottom it is H pixels.",
           "right on a square screen; if not square, stretched or squashed",
           return (ScreenPoint){place.s * screen.width, (1 - place.t) * screen.width})
WRONG_LINE(normalized_to_screen, "B-height", "(s H, (1 - t) H)",
           "H is used for both. From the left of the screen to the right it is W pixels.",
           "right on a square screen; if not square, stretched or squashed",
           return (ScreenPoint){place.s * screen.height, (1 - place.t) * screen.height})
WRONG_LINE(normalized_to_screen, "B-ss", "(s W, (1 - s) H)",
           "how far down a point is does not depend on s.", "every point on one diagonal",
           return (ScreenPoint){place.s * screen.width, (1 - place.s) * screen.height})
WRONG_LINE(
    normalized_to_screen, "B-order", "(s W, 1 - t H)",
    "1 is the whole height only before multiplying. After it, in pixels, 1 is just one pixel.",
    "everything above the screen",
    return (ScreenPoint){.x = place.s * screen.width, .y = 1 - place.t * screen.height})
WRONG_LINE(normalized_to_screen, "B-minus", "(s W, (t - 1) H)",
           "the subtraction is reversed: this is how far below the top the point is, but negative.",
           "everything above the screen, upside down",
           return (ScreenPoint){place.s * screen.width, (place.t - 1) * screen.height})
WRONG_LINE(normalized_to_screen, "B-plus", "(s W, (1 + t) H)",
           "a point further up has a smaller y. Here y is a whole height or more.",
           "everything below the screen, upside down",
           return (ScreenPoint){place.s * screen.width, (1 + place.t) * screen.height})
WRONG_LINE(
    normalized_to_screen, "B-last", "(s W, H - 1 - t H)",
    "H - 1 is the number of the last row. A point is continuous: the bottom edge is at y = H.",
    "a pixel too high",
    return (ScreenPoint){.x = place.s * screen.width,
                         .y = screen.height - 1 - place.t * screen.height})
WRONG_LINE(normalized_to_screen, "B-floor", "x and y truncated to whole pixels",
           "this is a pixel. A point may lie anywhere between whole numbers.",
           "up to a pixel off, to the left and upward",
           return (ScreenPoint){floor(place.s * screen.width),
                                floor((1 - place.t) * screen.height)})
WRONG_LINE(normalized_to_screen, "B-round", "x and y rounded to whole pixels",
           "a point may lie anywhere between whole numbers.", "up to half a pixel off",
           return (ScreenPoint){round(place.s * screen.width),
                                round((1 - place.t) * screen.height)})
WRONG_LINE(normalized_to_screen, "B-half", "half a pixel less",
           "half a pixel is the way from a pixel's corner to its centre. This point is exactly "
           "where s and t say.",
           "half a pixel off, to the left and upward",
           return (ScreenPoint){place.s * screen.width - 0.5, (1 - place.t) * screen.height - 0.5})
WRONG_LINE(normalized_to_screen, "B-half-more", "half a pixel more",
           "half a pixel is the way from a pixel's corner to its centre. This point is exactly "
           "where s and t say.",
           "half a pixel off, to the right and downward",
           return (ScreenPoint){place.s * screen.width + 0.5, (1 - place.t) * screen.height + 0.5})

WRONG(normalized_to_screen, "B-clamp", "x and y limited to the screen",
      "a place beyond 0..1 is beyond the screen; there is no limit at the edge.",
      "everything beyond the screen is drawn along its edge")
{
    double x = place.s * screen.width, y = (1 - place.t) * screen.height;
    return (ScreenPoint){fmin(fmax(x, 0), screen.width), fmin(fmax(y, 0), screen.height)};
}

WRONG_LINE(normalized_to_screen, "B-divide", "(s/W, (1 - t)/H)",
           "this is the other direction. A share becomes pixels when you multiply it by the whole.",
           "every point in the upper left pixel",
           return (ScreenPoint){place.s / screen.width, (1 - place.t) / screen.height})

// ---- wrong answers to exercise 03: centres of pixels, and the list of all tables ----------------

WRONG_LINE(pixel_center, "M-corner", "(column, row)",
           "this is the pixel's upper left corner, which it shares with three other pixels. If "
           "your code has 1 / 2: in C that is an integer division, and its result is 0.",
           "half a pixel off", return (ScreenPoint){pixel.column, pixel.row})
WRONG_LINE(pixel_center, "M-far", "(column + 1, row + 1)",
           "this is the pixel's lower right corner, across the whole square.",
           "half a pixel off the other way", return (ScreenPoint){pixel.column + 1, pixel.row + 1})
WRONG_LINE(pixel_center, "M-swap", "(row + 1/2, column + 1/2)",
           "x counts columns, from the left, and y counts rows, from the top.",
           "mirrored in the diagonal: rows become columns",
           return (ScreenPoint){pixel.row + 0.5, pixel.column + 0.5})
WRONG_LINE(pixel_center, "M-back", "(column - 1/2, row - 1/2)",
           "the pixel's square starts at (column, row) and extends right and down from there. This "
           "is the centre of another pixel.",
           "a whole pixel off, to the left and upward",
           return (ScreenPoint){pixel.column - 0.5, pixel.row - 0.5})
WRONG_LINE(pixel_center, "M-up", "(column + 1/2, row - 1/2)",
           "y grows downward, and the square extends down from its row. This is the centre of the "
           "pixel above.",
           "a pixel too high", return (ScreenPoint){pixel.column + 0.5, pixel.row - 0.5})
WRONG_LINE(
    pixel_center, "M-left", "(column - 1/2, row + 1/2)",
    "the square extends to the right from its column. This is the centre of the pixel on the left.",
    "a pixel too far left", return (ScreenPoint){pixel.column - 0.5, pixel.row + 0.5})
WRONG_LINE(pixel_center, "M-column", "(column + 1/2, row)",
           "this is the middle of the pixel's upper edge. A row also has a height: add half of it.",
           "half a pixel off, upward", return (ScreenPoint){pixel.column + 0.5, pixel.row})
WRONG_LINE(
    pixel_center, "M-row", "(column, row + 1/2)",
    "this is the middle of the pixel's left side. A column also has a width: add half of it.",
    "half a pixel off, to the left", return (ScreenPoint){pixel.column, pixel.row + 0.5})
WRONG_LINE(pixel_center, "M-average", "((column + 1)/2, (row + 1)/2)",
           "the column itself is halved. Only the added pixel is halved: column + 1/2.",
           "only the upper left quarter of the view, at twice its size",
           return (ScreenPoint){(pixel.column + 1) / 2.0, (pixel.row + 1) / 2.0})
WRONG_LINE(pixel_center, "M-times", "(column/2, row/2)",
           "this is half way from the corner of the screen to the pixel. The centre is half a "
           "pixel away from the pixel's own corner.",
           "only the upper left quarter of the view, at twice its size",
           return (ScreenPoint){0.5 * pixel.column, 0.5 * pixel.row})
WRONG_LINE(pixel_center, "M-double", "(2 column + 1, 2 row + 1)",
           "this counts in halves of a pixel. x and y count whole pixels.",
           "everything at half its size, in the upper left quarter",
           return (ScreenPoint){2 * pixel.column + 1, 2 * pixel.row + 1})
WRONG_LINE(pixel_center, "M-cc", "(column + 1/2, column + 1/2)",
           "how far down a pixel is depends on its row.",
           "stripes from top to bottom: all rows are alike",
           return (ScreenPoint){pixel.column + 0.5, pixel.column + 0.5})
WRONG_LINE(
    pixel_center, "M-down", "(column + 1/2, -(row + 1/2))",
    "y grows downward on the screen, as rows do. The axis is reversed later, in the step to t.",
    "upside down, and the view a whole picture too high",
    return (ScreenPoint){pixel.column + 0.5, -(pixel.row + 0.5)})

// ---- and back -----------------------------------------------------------------------------------

#define SEVEN_DIGITS "a float has 7 digits, and the answer needs more. Use double."

#define EDGES                                                                                      \
    "four pixels have five edges, and from the first edge to the last it is four pixels, not "     \
    "three."

WRONG_LINE(screen_to_normalized, "N3-x", "x/(W - 1)", EDGES, "everything slightly too wide",
           return (Normalized){point.x / (screen.width - 1), 1 - point.y / screen.height})
WRONG_LINE(screen_to_normalized, "N3-y", "y/(H - 1)", EDGES, "everything slightly too high",
           return (Normalized){point.x / screen.width, 1 - point.y / (screen.height - 1)})
WRONG_LINE(
    screen_to_normalized, "N-half-x", "(x + 1/2)/W",
    "x is a point already: add nothing to it. Pixels have centres; pixel_center is for them.",
    "half a pixel off, sideways",
    return (Normalized){(point.x + 0.5) / screen.width, 1 - point.y / screen.height})
WRONG_LINE(
    screen_to_normalized, "N-half-y", "1 - (y + 1/2)/H",
    "y is a point already: add nothing to it. Pixels have centres; pixel_center is for them.",
    "half a pixel off, up or down",
    return (Normalized){point.x / screen.width, 1 - (point.y + 0.5) / screen.height})
WRONG_LINE(screen_to_normalized, "N2-x", "(int)x/W",
           "in C, 300 / 640 is an integer division, and its result is 0. Your y is right.",
           "stripes from left to right: all columns are alike",
           return (Normalized){(int)point.x / screen.width, 1 - point.y / screen.height})
WRONG_LINE(screen_to_normalized, "N2-y", "1 - (int)y/H",
           "in C, 400 / 480 is an integer division, and its result is 0. Your x is right.",
           "stripes from top to bottom: all rows are alike",
           return (Normalized){point.x / screen.width, 1 - (int)point.y / screen.height})
WRONG_LINE(screen_to_normalized, "N7-x", "s = 2x/W - 1",
           "s goes from -1 to 1, and t from 0 to 1. Both must go from 0 to 1.",
           "everything at half its width, and shifted",
           return (Normalized){2 * point.x / screen.width - 1, 1 - point.y / screen.height})
WRONG_LINE(screen_to_normalized, "N7-y", "t = 1 - 2y/H",
           "t goes from -1 to 1, and s from 0 to 1. Both must go from 0 to 1.",
           "everything at half its height, and shifted",
           return (Normalized){point.x / screen.width, 1 - 2 * point.y / screen.height})

WRONG(screen_to_normalized, "N-float", "in float", SEVEN_DIGITS,
      "no visible difference, or ragged edges")
{
    float x = (float)point.x, y = (float)point.y;
    return (Normalized){x / (float)screen.width, 1 - y / (float)screen.height};
}

WRONG_LINE(normalized_to_screen, "B3-x", "s (W - 1)", EDGES, "everything slightly too narrow",
           return (ScreenPoint){place.s * (screen.width - 1), (1 - place.t) * screen.height})
WRONG_LINE(normalized_to_screen, "B3-y", "(1 - t)(H - 1)", EDGES, "everything slightly too low",
           return (ScreenPoint){place.s * screen.width, (1 - place.t) * (screen.height - 1)})

WRONG(normalized_to_screen, "B-float", "in float", SEVEN_DIGITS,
      "no visible difference, or ragged edges")
{
    float s = (float)place.s, t = (float)place.t;
    return (ScreenPoint){s * (float)screen.width, (1 - t) * (float)screen.height};
}

WRONG_LINE(pixel_center, "M-float", "in float",
           "a float has 7 digits: beyond 16777216 it holds only whole numbers, and not even all of "
           "them. Use double.",
           "no visible difference, except in enormous pictures",
           return (ScreenPoint){(float)pixel.column + 0.5f, (float)pixel.row + 0.5f})
