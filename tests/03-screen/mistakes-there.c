// mistakes-there.c - wrong conversions from a point of the screen to normalized coordinates.
#include "exercises/03-screen.h"
#include "tests/judge/mistake.h"

#include <math.h>

static Normalized not_turned_over(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, p.y / screen.height};
}

static Normalized whole_numbers_divided(ScreenPoint p, Resolution screen)
{
    int x = (int)p.x, y = (int)p.y;
    return (Normalized){x / screen.width, 1 - y / screen.height};
}

static Normalized one_pixel_less(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / (screen.width - 1), 1 - p.y / (screen.height - 1)};
}

static Normalized s_and_t_swapped(ScreenPoint p, Resolution screen)
{
    return (Normalized){1 - p.y / screen.height, p.x / screen.width};
}

static Normalized swapped_and_not_turned_over(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.y / screen.height, p.x / screen.width};
}

static Normalized x_turned_over(ScreenPoint p, Resolution screen)
{
    return (Normalized){1 - p.x / screen.width, p.y / screen.height};
}

static Normalized both_turned_over(ScreenPoint p, Resolution screen)
{
    return (Normalized){1 - p.x / screen.width, 1 - p.y / screen.height};
}

static Normalized from_minus_1_to_1(ScreenPoint p, Resolution screen)
{
    return (Normalized){2 * p.x / screen.width - 1, 1 - 2 * p.y / screen.height};
}

static Normalized from_minus_1_to_1_downward(ScreenPoint p, Resolution screen)
{
    return (Normalized){2 * p.x / screen.width - 1, 2 * p.y / screen.height - 1};
}

static Normalized from_the_middle(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width - 0.5, 0.5 - p.y / screen.height};
}

static Normalized sizes_swapped(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.height, 1 - p.y / screen.width};
}

static Normalized width_for_both(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, 1 - p.y / screen.width};
}

static Normalized height_for_both(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.height, 1 - p.y / screen.height};
}

static Normalized x_for_both(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, 1 - p.x / screen.width};
}

static Normalized turned_over_in_pixels(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, (1 - p.y) / screen.height};
}

static Normalized t_below_zero(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, p.y / screen.height - 1};
}

static Normalized t_above_one(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, 1 + p.y / screen.height};
}

static Normalized last_row_turned_over(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, (screen.height - 1 - p.y) / screen.height};
}

static Normalized whole_pixels_only(ScreenPoint p, Resolution screen)
{
    return (Normalized){floor(p.x) / screen.width, 1 - floor(p.y) / screen.height};
}

static Normalized half_a_pixel_added(ScreenPoint p, Resolution screen)
{
    return (Normalized){(p.x + 0.5) / screen.width, 1 - (p.y + 0.5) / screen.height};
}

static Normalized half_a_pixel_taken_off(ScreenPoint p, Resolution screen)
{
    return (Normalized){(p.x - 0.5) / screen.width, 1 - (p.y - 0.5) / screen.height};
}

static Normalized held_in_the_square(ScreenPoint p, Resolution screen)
{
    double s = p.x / screen.width, t = 1 - p.y / screen.height;
    return (Normalized){fmin(fmax(s, 0), 1), fmin(fmax(t, 0), 1)};
}

static Normalized half_of_whole_numbers(ScreenPoint p, Resolution screen)
{
    int half_width = screen.width / 2, half_height = screen.height / 2;
    return (Normalized){0.5 + 0.5 * (p.x - half_width) / fmax(half_width, 1),
                        0.5 - 0.5 * (p.y - half_height) / fmax(half_height, 1)};
}

static Normalized fractions_upside_down(ScreenPoint p, Resolution screen)
{
    return (Normalized){screen.width / p.x, 1 - screen.height / p.y};
}

static Normalized not_divided(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x, screen.height - p.y};
}

const Mistake there_mistakes[] = {
    MISTAKE("N1", screen_to_normalized, not_turned_over, "(x/W, y/H)",
            "y counts down from the top, t up from the bottom. This is the share of the way down.",
            "upside down"),
    MISTAKE(
        "N2", screen_to_normalized, whole_numbers_divided, "x/W and y/H in integers",
        "in C, 300 / 640 is an integer division: its result is 0 for every point on the screen.",
        "one flat colour"),
    MISTAKE("N3", screen_to_normalized, one_pixel_less, "(x/(W - 1), 1 - y/(H - 1))",
            "four pixels have five edges, and from the first edge to the last it is four pixels, "
            "not three.",
            "everything slightly too small; on a single pixel, nothing"),
    MISTAKE("N4", screen_to_normalized, s_and_t_swapped, "s from y, t from x",
            "s goes across, as x does, and t goes up. Here they are swapped.",
            "mirrored in the diagonal: rows become columns"),
    MISTAKE("N4-N1", screen_to_normalized, swapped_and_not_turned_over, "(y/H, x/W)",
            "s goes across, as x does; and y counts down while t counts up.", "turned on its side"),
    MISTAKE("N6", screen_to_normalized, x_turned_over, "(1 - x/W, y/H)",
            "y runs against t, but x does not run against s: both go to the right.",
            "turned by 180 degrees"),
    MISTAKE("N6-both", screen_to_normalized, both_turned_over, "(1 - x/W, 1 - y/H)",
            "x and s both go to the right, from the same edge. Only the vertical axis is reversed.",
            "mirrored: left and right swapped"),
    MISTAKE(
        "N7", screen_to_normalized, from_minus_1_to_1, "(2 x/W - 1, 1 - 2 y/H)",
        "this is 0 in the middle and runs from -1 to 1. s and t are 0 at the lower left corner.",
        "shifted, and everything at half its size"),
    MISTAKE("N7-N1", screen_to_normalized, from_minus_1_to_1_downward, "(2 x/W - 1, 2 y/H - 1)",
            "this runs from -1 to 1, and downward. s and t are 0 at the lower left corner.",
            "shifted, at half its size and upside down"),
    MISTAKE("N7-half", screen_to_normalized, from_the_middle, "(x/W - 1/2, 1/2 - y/H)",
            "this counts from the middle of the screen. s and t are 0 at the lower left corner.",
            "the middle of the view in the upper right corner"),
    MISTAKE("N-sizes", screen_to_normalized, sizes_swapped, "(x/H, 1 - y/W)",
            "the screen is W wide and H high. x runs across and y down.",
            "right on a square screen; if not square, squashed and cut off"),
    MISTAKE("N-width", screen_to_normalized, width_for_both, "(x/W, 1 - y/W)",
            "W is used for both. From the top of the screen to the bottom it is H pixels.",
            "right on a square screen; if not square, out of shape and shifted"),
    MISTAKE("N-height", screen_to_normalized, height_for_both, "(x/H, 1 - y/H)",
            "H is used for both. From the left of the screen to the right it is W pixels.",
            "right on a square screen; if not square, out of shape and shifted"),
    MISTAKE("N-xx", screen_to_normalized, x_for_both, "(x/W, 1 - x/W)",
            "how far up a point is does not depend on x.",
            "stripes from top to bottom: all rows are alike"),
    MISTAKE("N-order", screen_to_normalized, turned_over_in_pixels, "(x/W, (1 - y)/H)",
            "1 is the whole height only after dividing. Before, in pixels, 1 is just one pixel.",
            "the view almost a whole picture too low"),
    MISTAKE("N-minus", screen_to_normalized, t_below_zero, "(x/W, y/H - 1)",
            "the subtraction is reversed: t is 1 minus the share of the way down, and not below 0 "
            "on the screen.",
            "upside down, and the view a whole picture too low"),
    MISTAKE("N-plus", screen_to_normalized, t_above_one, "(x/W, 1 + y/H)",
            "a point further down has a smaller t. Here t is 1 at the top and grows to 2 downward.",
            "upside down, and the view a whole picture too high"),
    MISTAKE(
        "N-last", screen_to_normalized, last_row_turned_over, "(x/W, (H - 1 - y)/H)",
        "H - 1 is the number of the last row. A point is continuous: the bottom edge is at y = H.",
        "the view a pixel too low"),
    MISTAKE(
        "N-floor", screen_to_normalized, whole_pixels_only, "x and y truncated to integers",
        "a point may lie anywhere in a pixel. Here all points of a pixel have become its corner.",
        "half a pixel off"),
    MISTAKE("N-half", screen_to_normalized, half_a_pixel_added, "((x + 1/2)/W, 1 - (y + 1/2)/H)",
            "half a pixel is the way from a pixel to its centre, and this is a point already.",
            "half a pixel off: added twice"),
    MISTAKE("N-half-less", screen_to_normalized, half_a_pixel_taken_off,
            "((x - 1/2)/W, 1 - (y - 1/2)/H)",
            "0 is at the edge of the screen, and a point is counted from there already.",
            "half a pixel off"),
    MISTAKE("N-clamp", screen_to_normalized, held_in_the_square, "s and t limited to 0..1",
            "a point beyond the screen is beyond 0..1; there is no limit at the edge.",
            "the same picture; beyond the edges, the edge is repeated"),
    MISTAKE("N-odd", screen_to_normalized, half_of_whole_numbers, "W/2 and H/2 in integers",
            "in C, 3 / 2 is an integer division, and its result is 1. The middle of a screen may "
            "be half way across a pixel.",
            "right for even sizes; slightly off for odd ones"),
    MISTAKE("N-over", screen_to_normalized, fractions_upside_down, "(W/x, 1 - H/y)",
            "the fractions are upside down. A share is the part divided by the whole.",
            "nothing recognisable"),
    MISTAKE("N-pixels", screen_to_normalized, not_divided, "(x, H - y)",
            "reversed, but still in pixels. s and t are shares of the screen, without a unit.",
            "one flat colour: after the first pixel the rays leave the view"),
    {0},
};
