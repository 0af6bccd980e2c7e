// 03-screen.c - wrong answers to exercise 03.
#include "exercises/03-screen.h"

#include "tests/mistakes/mistakes.h"

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

static Normalized width_and_height_swapped(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.height, 1 - p.y / screen.width};
}

static Normalized width_for_both(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, 1 - p.y / screen.width};
}

static Normalized turned_over_in_pixels(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, (1 - p.y) / screen.height};
}

static Normalized t_below_zero(ScreenPoint p, Resolution screen)
{
    return (Normalized){p.x / screen.width, p.y / screen.height - 1};
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

static ScreenPoint back_not_turned_over(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width, place.t * screen.height};
}

static ScreenPoint back_one_pixel_less(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * (screen.width - 1), (1 - place.t) * (screen.height - 1)};
}

static ScreenPoint back_swapped(Normalized place, Resolution screen)
{
    return (ScreenPoint){(1 - place.t) * screen.width, place.s * screen.height};
}

static ScreenPoint back_x_turned_over(Normalized place, Resolution screen)
{
    return (ScreenPoint){(1 - place.s) * screen.width, place.t * screen.height};
}

static ScreenPoint back_sizes_swapped(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.height, (1 - place.t) * screen.width};
}

static ScreenPoint back_in_pixels(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width, 1 - place.t * screen.height};
}

static ScreenPoint back_above_the_screen(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width, (place.t - 1) * screen.height};
}

static ScreenPoint back_to_whole_pixels(Normalized place, Resolution screen)
{
    return (ScreenPoint){floor(place.s * screen.width), floor((1 - place.t) * screen.height)};
}

static ScreenPoint back_rounded(Normalized place, Resolution screen)
{
    return (ScreenPoint){round(place.s * screen.width), round((1 - place.t) * screen.height)};
}

static ScreenPoint back_half_a_pixel_less(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width - 0.5, (1 - place.t) * screen.height - 0.5};
}

static ScreenPoint back_held_on_the_screen(Normalized place, Resolution screen)
{
    double x = place.s * screen.width, y = (1 - place.t) * screen.height;
    return (ScreenPoint){fmin(fmax(x, 0), screen.width), fmin(fmax(y, 0), screen.height)};
}

static ScreenPoint back_by_dividing(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s / screen.width, (1 - place.t) / screen.height};
}

static ScreenPoint corner_of_the_pixel(Pixel pixel)
{
    return (ScreenPoint){pixel.column, pixel.row};
}

static ScreenPoint far_corner_of_the_pixel(Pixel pixel)
{
    return (ScreenPoint){pixel.column + 1, pixel.row + 1};
}

static ScreenPoint row_and_column_swapped(Pixel pixel)
{
    return (ScreenPoint){pixel.row + 0.5, pixel.column + 0.5};
}

static ScreenPoint half_a_pixel_back(Pixel pixel)
{
    return (ScreenPoint){pixel.column - 0.5, pixel.row - 0.5};
}

static ScreenPoint half_a_pixel_up(Pixel pixel)
{
    return (ScreenPoint){pixel.column + 0.5, pixel.row - 0.5};
}

static ScreenPoint half_of_the_column(Pixel pixel)
{
    return (ScreenPoint){(pixel.column + 1) / 2.0, (pixel.row + 1) / 2.0};
}

static ScreenPoint only_the_column(Pixel pixel)
{
    return (ScreenPoint){pixel.column + 0.5, pixel.row};
}

const Mistake mistakes[] = {
    MISTAKE("N1", screen_to_normalized, not_turned_over, "y not turned over"),
    MISTAKE("N2", screen_to_normalized, whole_numbers_divided, "integer division"),
    MISTAKE("N3", screen_to_normalized, one_pixel_less, "divided by W - 1, H - 1"),
    MISTAKE("N4", screen_to_normalized, s_and_t_swapped, "s and t swapped"),
    MISTAKE("N6", screen_to_normalized, x_turned_over, "x turned over, not y"),
    MISTAKE("N6-both", screen_to_normalized, both_turned_over, "x turned over as well"),
    MISTAKE("N7", screen_to_normalized, from_minus_1_to_1, "onto -1..1"),
    MISTAKE("N-sizes", screen_to_normalized, width_and_height_swapped, "x / H, y / W"),
    MISTAKE("N-width", screen_to_normalized, width_for_both, "W for both"),
    MISTAKE("N-order", screen_to_normalized, turned_over_in_pixels, "(1 - y) / H"),
    MISTAKE("N-minus", screen_to_normalized, t_below_zero, "y / H - 1"),
    MISTAKE("N-last", screen_to_normalized, last_row_turned_over, "H - 1 - y, as for a row"),
    MISTAKE("N-floor", screen_to_normalized, whole_pixels_only, "the point cut to whole pixels"),
    MISTAKE("N-half", screen_to_normalized, half_a_pixel_added, "half a pixel added to a point"),
    MISTAKE("N-clamp", screen_to_normalized, held_in_the_square, "s and t held in 0..1"),
    MISTAKE("N-odd", screen_to_normalized, half_of_whole_numbers, "W / 2 and H / 2 as integers"),
    MISTAKE("B1", normalized_to_screen, back_not_turned_over, "t not turned over"),
    MISTAKE("B3", normalized_to_screen, back_one_pixel_less, "times W - 1, H - 1"),
    MISTAKE("B4", normalized_to_screen, back_swapped, "x from t, y from s"),
    MISTAKE("B6", normalized_to_screen, back_x_turned_over, "s turned over, not t"),
    MISTAKE("B-sizes", normalized_to_screen, back_sizes_swapped, "s H, (1 - t) W"),
    MISTAKE("B-order", normalized_to_screen, back_in_pixels, "1 - t H"),
    MISTAKE("B-minus", normalized_to_screen, back_above_the_screen, "(t - 1) H"),
    MISTAKE("B-floor", normalized_to_screen, back_to_whole_pixels, "cut to whole pixels"),
    MISTAKE("B-round", normalized_to_screen, back_rounded, "rounded to whole pixels"),
    MISTAKE("B-half", normalized_to_screen, back_half_a_pixel_less, "half a pixel taken off"),
    MISTAKE("B-clamp", normalized_to_screen, back_held_on_the_screen, "held on the screen"),
    MISTAKE("B-divide", normalized_to_screen, back_by_dividing, "divided by W and H again"),
    MISTAKE("M-corner", pixel_center, corner_of_the_pixel, "the pixel's corner, not its centre"),
    MISTAKE("M-far", pixel_center, far_corner_of_the_pixel, "the pixel's far corner"),
    MISTAKE("M-swap", pixel_center, row_and_column_swapped, "row and column swapped"),
    MISTAKE("M-back", pixel_center, half_a_pixel_back, "half a pixel taken off"),
    MISTAKE("M-up", pixel_center, half_a_pixel_up, "half a pixel up, not down"),
    MISTAKE("M-average", pixel_center, half_of_the_column, "(column + 1) / 2"),
    MISTAKE("M-column", pixel_center, only_the_column, "the row's half left out"),
    {0},
};
