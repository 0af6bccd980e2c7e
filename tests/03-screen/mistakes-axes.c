// mistakes-axes.c - slips on one axis only, and answers in fewer digits.
#include "exercises/03-screen.h"
#include "tests/judge/mistake.h"

// ---- from the screen to the square --------------------------------------------------------------

static Normalized one_column_less(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / (screen.width - 1), 1 - p.y / screen.height};
}

static Normalized one_row_less(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, 1 - p.y / (screen.height - 1)};
}

static Normalized half_a_column_added(ScreenPoint p, Resolution screen)
{
    return (Normalized){(p.x + 0.5) / screen.width, 1 - p.y / screen.height};
}

static Normalized half_a_row_added(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, 1 - (p.y + 0.5) / screen.height};
}

static Normalized whole_x_only(ScreenPoint p, Resolution screen)
{
    return (Normalized){(int)p.x / screen.width, 1 - p.y / screen.height};
}

static Normalized whole_y_only(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, 1 - (int)p.y / screen.height};
}

static Normalized s_from_minus_1(ScreenPoint p, Resolution screen)
{
    return (Normalized){2 * p.x / screen.width - 1, 1 - p.y / screen.height};
}

static Normalized t_from_minus_1(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, 1 - 2 * p.y / screen.height};
}

static Normalized shares_in_float(ScreenPoint p, Resolution screen)
{
    float x = (float)p.x, y = (float)p.y;
    return (Normalized){x / (float)screen.width, 1 - y / (float)screen.height};
}

// ---- and back -----------------------------------------------------------------------------------

static ScreenPoint back_one_column_less(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * (screen.width - 1), (1 - place.t) * screen.height};
}

static ScreenPoint back_one_row_less(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width, (1 - place.t) * (screen.height - 1)};
}

static ScreenPoint pixels_in_float(Normalized place, Resolution screen)
{
    float s = (float)place.s, t = (float)place.t;
    return (ScreenPoint){s * (float)screen.width, (1 - t) * (float)screen.height};
}

static ScreenPoint center_in_float(Pixel pixel)
{
    return (ScreenPoint){(float)pixel.column + 0.5f, (float)pixel.row + 0.5f};
}

#define SEVEN_DIGITS "a float has 7 digits, and the answer needs more. Use double."
#define EDGES                                                                                      \
    "four pixels have five edges, and from the first edge to the last it is four pixels, not "     \
    "three."

const Mistake screen_axis_mistakes[] = {
    MISTAKE("N3-x", screen_to_normalized, one_column_less, "x/(W - 1)", EDGES,
            "everything slightly too wide"),
    MISTAKE("N3-y", screen_to_normalized, one_row_less, "y/(H - 1)", EDGES,
            "everything slightly too high"),
    MISTAKE(
        "N-half-x", screen_to_normalized, half_a_column_added, "(x + 1/2)/W",
        "x is a point already: add nothing to it. Pixels have centres; pixel_center is for them.",
        "half a pixel off, sideways"),
    MISTAKE(
        "N-half-y", screen_to_normalized, half_a_row_added, "1 - (y + 1/2)/H",
        "y is a point already: add nothing to it. Pixels have centres; pixel_center is for them.",
        "half a pixel off, up or down"),
    MISTAKE("N2-x", screen_to_normalized, whole_x_only, "(int)x/W",
            "in C, 300 / 640 is an integer division, and its result is 0. Your y is right.",
            "stripes from left to right: all columns are alike"),
    MISTAKE("N2-y", screen_to_normalized, whole_y_only, "1 - (int)y/H",
            "in C, 400 / 480 is an integer division, and its result is 0. Your x is right.",
            "stripes from top to bottom: all rows are alike"),
    MISTAKE("N7-x", screen_to_normalized, s_from_minus_1, "s = 2x/W - 1",
            "s goes from -1 to 1, and t from 0 to 1. Both must go from 0 to 1.",
            "everything at half its width, and shifted"),
    MISTAKE("N7-y", screen_to_normalized, t_from_minus_1, "t = 1 - 2y/H",
            "t goes from -1 to 1, and s from 0 to 1. Both must go from 0 to 1.",
            "everything at half its height, and shifted"),
    MISTAKE("N-float", screen_to_normalized, shares_in_float, "in float", SEVEN_DIGITS,
            "no visible difference, or ragged edges"),
    MISTAKE("B3-x", normalized_to_screen, back_one_column_less, "s (W - 1)", EDGES,
            "everything slightly too narrow"),
    MISTAKE("B3-y", normalized_to_screen, back_one_row_less, "(1 - t)(H - 1)", EDGES,
            "everything slightly too low"),
    MISTAKE("B-float", normalized_to_screen, pixels_in_float, "in float", SEVEN_DIGITS,
            "no visible difference, or ragged edges"),
    MISTAKE("M-float", pixel_center, center_in_float, "in float",
            "a float has 7 digits: beyond 16777216 it holds only whole numbers, and not even all "
            "of them. Use double.",
            "no visible difference, except in enormous pictures"),
    {0},
};
