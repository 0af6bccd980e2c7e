// right.c - right answers to exercise 03, written in other ways.
#include "exercises/03-screen.h"

#include "tests/judge/known.h"

RIGHT(screen_to_normalized, "the rest of the height, divided")
{
    Normalized normalized;
    normalized.s = point.x / (double)screen.width;
    normalized.t = (screen.height - point.y) / screen.height;
    return normalized;
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
           return (ScreenPoint){.x = screen.width * normalized.s,
                                .y = screen.height - normalized.t * screen.height})

RIGHT_LINE(screen_to_normalized, "in long double",
           return (Normalized){(double)((long double)point.x / screen.width),
                               (double)(1 - (long double)point.y / screen.height)})
