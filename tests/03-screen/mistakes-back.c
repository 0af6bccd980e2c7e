// mistakes-back.c - wrong conversions from normalized coordinates to the point of the screen.
#include "exercises/03-screen.h"
#include "tests/judge/mistake.h"

#include <math.h>

static ScreenPoint not_turned_over(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width, place.t * screen.height};
}

static ScreenPoint shares_cut_to_whole_numbers(Normalized place, Resolution screen)
{
    return (ScreenPoint){(int)place.s * screen.width, (1 - (int)place.t) * screen.height};
}

static ScreenPoint one_pixel_less(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * (screen.width - 1), (1 - place.t) * (screen.height - 1)};
}

static ScreenPoint x_from_t(Normalized place, Resolution screen)
{
    return (ScreenPoint){(1 - place.t) * screen.width, place.s * screen.height};
}

static ScreenPoint x_from_t_and_not_turned_over(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.t * screen.width, place.s * screen.height};
}

static ScreenPoint x_turned_over(Normalized place, Resolution screen)
{
    return (ScreenPoint){(1 - place.s) * screen.width, place.t * screen.height};
}

static ScreenPoint both_turned_over(Normalized place, Resolution screen)
{
    return (ScreenPoint){(1 - place.s) * screen.width, (1 - place.t) * screen.height};
}

static ScreenPoint from_minus_1_to_1(Normalized place, Resolution screen)
{
    return (ScreenPoint){(place.s + 1) / 2 * screen.width, (1 - place.t) / 2 * screen.height};
}

static ScreenPoint from_the_middle(Normalized place, Resolution screen)
{
    return (ScreenPoint){(place.s - 0.5) * screen.width, (0.5 - place.t) * screen.height};
}

static ScreenPoint sizes_swapped(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.height, (1 - place.t) * screen.width};
}

static ScreenPoint width_for_both(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width, (1 - place.t) * screen.width};
}

static ScreenPoint height_for_both(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.height, (1 - place.t) * screen.height};
}

static ScreenPoint s_for_both(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width, (1 - place.s) * screen.height};
}

static ScreenPoint turned_over_in_pixels(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width, 1 - place.t * screen.height};
}

static ScreenPoint above_the_screen(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width, (place.t - 1) * screen.height};
}

static ScreenPoint below_the_screen(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width, (1 + place.t) * screen.height};
}

static ScreenPoint last_row_turned_over(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width, screen.height - 1 - place.t * screen.height};
}

static ScreenPoint cut_to_whole_pixels(Normalized place, Resolution screen)
{
    return (ScreenPoint){floor(place.s * screen.width), floor((1 - place.t) * screen.height)};
}

static ScreenPoint rounded(Normalized place, Resolution screen)
{
    return (ScreenPoint){round(place.s * screen.width), round((1 - place.t) * screen.height)};
}

static ScreenPoint half_a_pixel_less(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width - 0.5, (1 - place.t) * screen.height - 0.5};
}

static ScreenPoint half_a_pixel_more(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width + 0.5, (1 - place.t) * screen.height + 0.5};
}

static ScreenPoint held_on_the_screen(Normalized place, Resolution screen)
{
    double x = place.s * screen.width, y = (1 - place.t) * screen.height;
    return (ScreenPoint){fmin(fmax(x, 0), screen.width), fmin(fmax(y, 0), screen.height)};
}

static ScreenPoint divided_again(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s / screen.width, (1 - place.t) / screen.height};
}

const Mistake back_mistakes[] = {
    MISTAKE(
        "B1", normalized_to_screen, not_turned_over, "(s W, t H)",
        "t counts up from the bottom, y down from the top. This is the height above the bottom.",
        "upside down"),
    MISTAKE("B2", normalized_to_screen, shares_cut_to_whole_numbers,
            "s and t truncated to integers",
            "the share is converted to an integer before the multiplication, and everywhere inside "
            "the screen the result is 0.",
            "every point in the lower left corner"),
    MISTAKE("B3", normalized_to_screen, one_pixel_less, "(s (W - 1), (1 - t) (H - 1))",
            "four pixels have five edges, and from the first edge to the last it is four pixels, "
            "not three.",
            "slightly too small: the last column and row stay empty"),
    MISTAKE("B4", normalized_to_screen, x_from_t, "x from t, y from s",
            "s goes across, as x does, and t goes up. Here they are swapped.",
            "mirrored in the diagonal: rows become columns"),
    MISTAKE("B4-B1", normalized_to_screen, x_from_t_and_not_turned_over, "(t W, s H)",
            "s goes across, as x does; and t counts up while y counts down.", "turned on its side"),
    MISTAKE("B6", normalized_to_screen, x_turned_over, "((1 - s) W, t H)",
            "t runs against y, but s does not run against x: both go to the right.",
            "turned by 180 degrees"),
    MISTAKE("B6-both", normalized_to_screen, both_turned_over, "((1 - s) W, (1 - t) H)",
            "s and x both go to the right, from the same edge. Only the vertical axis is reversed.",
            "mirrored: left and right swapped"),
    MISTAKE("B7", normalized_to_screen, from_minus_1_to_1, "((s + 1)/2 W, (1 - t)/2 H)",
            "this assumes that s and t run from -1 to 1. They are 0 at the lower left corner and 1 "
            "at the upper right.",
            "everything in the upper right quarter of the screen"),
    MISTAKE("B7-half", normalized_to_screen, from_the_middle, "((s - 1/2) W, (1/2 - t) H)",
            "this counts from the middle of the screen. x and y are 0 at the upper left corner.",
            "shifted by half a screen"),
    MISTAKE("B-sizes", normalized_to_screen, sizes_swapped, "(s H, (1 - t) W)",
            "the screen is W wide and H high. s goes across and t up.",
            "right on a square screen; if not square, squashed and cut off"),
    MISTAKE("B-width", normalized_to_screen, width_for_both, "(s W, (1 - t) W)",
            "W is used for both. From the top of the screen to the bottom it is H pixels.",
            "right on a square screen; if not square, stretched or squashed"),
    MISTAKE("B-height", normalized_to_screen, height_for_both, "(s H, (1 - t) H)",
            "H is used for both. From the left of the screen to the right it is W pixels.",
            "right on a square screen; if not square, stretched or squashed"),
    MISTAKE("B-ss", normalized_to_screen, s_for_both, "(s W, (1 - s) H)",
            "how far down a point is does not depend on s.", "every point on one diagonal"),
    MISTAKE(
        "B-order", normalized_to_screen, turned_over_in_pixels, "(s W, 1 - t H)",
        "1 is the whole height only before multiplying. After it, in pixels, 1 is just one pixel.",
        "everything above the screen"),
    MISTAKE(
        "B-minus", normalized_to_screen, above_the_screen, "(s W, (t - 1) H)",
        "the subtraction is reversed: this is how far below the top the point is, but negative.",
        "everything above the screen, upside down"),
    MISTAKE("B-plus", normalized_to_screen, below_the_screen, "(s W, (1 + t) H)",
            "a point further up has a smaller y. Here y is a whole height or more.",
            "everything below the screen, upside down"),
    MISTAKE(
        "B-last", normalized_to_screen, last_row_turned_over, "(s W, H - 1 - t H)",
        "H - 1 is the number of the last row. A point is continuous: the bottom edge is at y = H.",
        "a pixel too high"),
    MISTAKE("B-floor", normalized_to_screen, cut_to_whole_pixels,
            "x and y truncated to whole pixels",
            "this is a pixel. A point may lie anywhere between whole numbers.",
            "up to a pixel off, to the left and upward"),
    MISTAKE("B-round", normalized_to_screen, rounded, "x and y rounded to whole pixels",
            "a point may lie anywhere between whole numbers.", "up to half a pixel off"),
    MISTAKE("B-half", normalized_to_screen, half_a_pixel_less, "half a pixel less",
            "half a pixel is the way from a pixel's corner to its centre. This point is exactly "
            "where s and t say.",
            "half a pixel off, to the left and upward"),
    MISTAKE("B-half-more", normalized_to_screen, half_a_pixel_more, "half a pixel more",
            "half a pixel is the way from a pixel's corner to its centre. This point is exactly "
            "where s and t say.",
            "half a pixel off, to the right and downward"),
    MISTAKE("B-clamp", normalized_to_screen, held_on_the_screen, "x and y limited to the screen",
            "a place beyond 0..1 is beyond the screen; there is no limit at the edge.",
            "everything beyond the screen is drawn along its edge"),
    MISTAKE(
        "B-divide", normalized_to_screen, divided_again, "(s/W, (1 - t)/H)",
        "this is the other direction. A share becomes pixels when you multiply it by the whole.",
        "every point in the upper left pixel"),
    {0},
};
