// right.c - right answers to exercise 03, written in other ways.
#include "exercises/03-screen.h"

#include "tests/judge/known.h"

static double middle(int number)
{
    return (2 * number + 1) * 0.5;
}

// The position of x between two ends, as a share.
static double share(double x, double from, double to)
{
    return (x - from) / (to - from);
}

static double between(double from, double to, double part)
{
    return (1 - part) * from + part * to;
}

RIGHT(screen_to_normalized, "the rest of the height, divided")
{
    Normalized place;
    place.s = point.x / (double)screen.width;
    place.t = (screen.height - point.y) / screen.height;
    return place;
}

RIGHT(screen_to_normalized, "counted from the middle")
{
    double right = point.x - screen.width / 2.0, down = point.y - screen.height / 2.0;
    return (Normalized){0.5 + right / screen.width, 0.5 - down / screen.height};
}

RIGHT(screen_to_normalized, "times the size of a pixel")
{
    double pixel_width = 1.0 / screen.width, pixel_height = 1.0 / screen.height;
    return (Normalized){.t = -(point.y * pixel_height - 1), .s = point.x * pixel_width};
}

RIGHT_LINE(normalized_to_screen, "up from the bottom edge",
           return (ScreenPoint){.x = screen.width * place.s,
                                .y = screen.height - place.t * screen.height})

RIGHT(normalized_to_screen, "minus the height, times t - 1")
{
    double y = -screen.height * (place.t - 1);
    return (ScreenPoint){.x = place.s * screen.width, .y = y};
}

RIGHT(pixel_center, "half way between the corners")
{
    int left = pixel.column, right = left + 1, top = pixel.row, bottom = top + 1;
    return (ScreenPoint){(left + right) / 2.0, (top + bottom) / 2.0};
}

RIGHT_LINE(pixel_center, "a helper, in integers as long as possible",
           return (ScreenPoint){middle(pixel.column), middle(pixel.row)})
RIGHT_LINE(screen_to_normalized, "a helper: the share between two ends",
           return (Normalized){share(point.x, 0, screen.width), share(point.y, screen.height, 0)})
RIGHT_LINE(screen_to_normalized, "in long double",
           return (Normalized){(double)((long double)point.x / screen.width),
                               (double)(1 - (long double)point.y / screen.height)})
RIGHT_LINE(normalized_to_screen, "a helper: between two ends",
           return (ScreenPoint){between(0, screen.width, place.s),
                                between(screen.height, 0, place.t)})

// The rows of a matrix for (s, t, 1).
RIGHT(normalized_to_screen, "a matrix for (s, t, 1)")
{
    double rows[2][3] = {{screen.width, 0, 0}, {0, -screen.height, screen.height}};
    double in[3] = {place.s, place.t, 1}, out[2] = {0, 0};
    for (int row = 0; row < 2; row++)
        for (int column = 0; column < 3; column++)
            out[row] += rows[row][column] * in[column];
    return (ScreenPoint){out[0], out[1]};
}

RIGHT(pixel_center, "the corner, moved")
{
    ScreenPoint center = {.x = pixel.column, .y = pixel.row};
    center.x += .5;
    center.y += 1. / 2;
    return center;
}
