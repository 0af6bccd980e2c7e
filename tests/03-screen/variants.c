// variants.c - right answers to exercise 03, written in other ways.
#include "exercises/03-screen.h"

#include "tests/proof/variants.h"

static Normalized rest_of_the_height(ScreenPoint p, Resolution screen)
{
    Normalized place;
    place.s = p.x / (double)screen.width;
    place.t = (screen.height - p.y) / screen.height;
    return place;
}

static Normalized from_the_middle(ScreenPoint p, Resolution screen)
{
    double right = p.x - screen.width / 2.0, down = p.y - screen.height / 2.0;
    return (Normalized){0.5 + right / screen.width, 0.5 - down / screen.height};
}

static Normalized times_the_reciprocal(ScreenPoint p, Resolution screen)
{
    double pixel_width = 1.0 / screen.width, pixel_height = 1.0 / screen.height;
    return (Normalized){.t = -(p.y * pixel_height - 1), .s = p.x * pixel_width};
}

static ScreenPoint up_from_the_bottom(Normalized place, Resolution screen)
{
    return (ScreenPoint){screen.width * place.s, screen.height - place.t * screen.height};
}

static ScreenPoint sign_outside(Normalized place, Resolution screen)
{
    double y = -screen.height * (place.t - 1);
    return (ScreenPoint){.x = place.s * screen.width, .y = y};
}

static ScreenPoint between_the_corners(Pixel pixel)
{
    int left = pixel.column, right = left + 1, top = pixel.row, bottom = top + 1;
    return (ScreenPoint){(left + right) / 2.0, (top + bottom) / 2.0};
}

static double middle(int number)
{
    return (2 * number + 1) * 0.5;
}

static ScreenPoint by_a_helper(Pixel pixel)
{
    return (ScreenPoint){middle(pixel.column), middle(pixel.row)};
}

// The position of x between two ends, as a share.
static double share(double x, double from, double to)
{
    return (x - from) / (to - from);
}

static Normalized inverse_lerp(ScreenPoint p, Resolution screen)
{
    return (Normalized){share(p.x, 0, screen.width), share(p.y, screen.height, 0)};
}

static Normalized in_long_double(ScreenPoint p, Resolution screen)
{
    return (Normalized){(double)((long double)p.x / screen.width),
                        (double)(1 - (long double)p.y / screen.height)};
}

static double between(double from, double to, double part)
{
    return (1 - part) * from + part * to;
}

static ScreenPoint lerp(Normalized place, Resolution screen)
{
    return (ScreenPoint){between(0, screen.width, place.s), between(screen.height, 0, place.t)};
}

// The rows of a matrix for (s, t, 1).
static ScreenPoint by_a_matrix(Normalized place, Resolution screen)
{
    double rows[2][3] = {{screen.width, 0, 0}, {0, -screen.height, screen.height}};
    double in[3] = {place.s, place.t, 1}, out[2] = {0, 0};
    for (int row = 0; row < 2; row++)
        for (int column = 0; column < 3; column++)
            out[row] += rows[row][column] * in[column];
    return (ScreenPoint){out[0], out[1]};
}

static ScreenPoint moved_by_half(Pixel pixel)
{
    ScreenPoint center = {.x = pixel.column, .y = pixel.row};
    center.x += .5;
    center.y += 1. / 2;
    return center;
}

static const Variant variants[] = {
    VARIANT(screen_to_normalized, rest_of_the_height, "the rest of the height, divided"),
    VARIANT(screen_to_normalized, from_the_middle, "counted from the middle"),
    VARIANT(screen_to_normalized, times_the_reciprocal, "times the size of a pixel"),
    VARIANT(normalized_to_screen, up_from_the_bottom, "up from the bottom edge"),
    VARIANT(normalized_to_screen, sign_outside, "minus the height, times t - 1"),
    VARIANT(pixel_center, between_the_corners, "half way between the corners"),
    VARIANT(pixel_center, by_a_helper, "a helper, in integers as long as possible"),
    VARIANT(screen_to_normalized, inverse_lerp, "a helper: the share between two ends"),
    VARIANT(screen_to_normalized, in_long_double, "in long double"),
    VARIANT(normalized_to_screen, lerp, "a helper: between two ends"),
    VARIANT(normalized_to_screen, by_a_matrix, "a matrix for (s, t, 1)"),
    VARIANT(pixel_center, moved_by_half, "the corner, moved"),
    {0},
};
OF_STEM(variants)
