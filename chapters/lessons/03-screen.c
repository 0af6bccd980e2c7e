// 03-screen.c - the numbers of lesson 03.
#include "exercises/03-screen.h"

#include "chapters/lessons/fill.h"
#include "chapters/shared/digits.h"
#include "chapters/shared/example.h"
#include "common/shown.h"

#include <math.h>

// The shape of a screen on which the example's camera shows a ball as a ball.
static void fill_shape(Camera c)
{
    double ratio = c.width / c.height;
    if (fabs(ratio - 1) < 1e-9)
        fill_text("needed_screen", "a square screen");
    else
        fill_text("needed_screen", "a screen whose width is %s times its height",
                  number_shown(ratio).s);
}

void fill_numbers(void)
{
    Resolution screen = example_screen();
    Pixel pixel = example_pixel();
    ScreenPoint point = example_point(), center = pixel_center(pixel);
    Normalized place = screen_to_normalized(point, screen);
    Normalized center_place = screen_to_normalized(center, screen);
    int digits = place_digits(screen);
    fill_number("W", screen.width);
    fill_text("column_in_C", "%d", pixel.column);
    fill_text("W_in_C", "%d", screen.width);
    fill_number("H", screen.height);
    fill_number("almost_W", screen.width - 0.3);
    fill_number("x", point.x);
    fill_number("y", point.y);
    fill_number("column", pixel.column);
    fill_number("row", pixel.row);
    fill_number("next_column", pixel.column + 1);
    fill_number("next_row", pixel.row + 1);
    fill_result("is_s", place.s, digits);
    fill_result("is_t", place.t, digits);
    fill_text("center", "%s", pair_shown(center.x, center.y).s);
    fill_text("center_place", "%s", pair_shown_to(center_place.s, center_place.t, digits).s);
    fill_number("w", example_camera().width);
    fill_number("h", example_camera().height);
    fill_shape(example_camera());
}
