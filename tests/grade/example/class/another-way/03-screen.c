#include "exercises/03-screen.h"

#include <stdio.h>

Normalized screen_to_normalized(ScreenPoint p, Resolution screen)
{
    Normalized n;
    double from_below = screen.height - p.y;
    n.s = p.x / screen.width;
    n.t = from_below / screen.height;
    printf("s %f t %f\n", n.s, n.t);
    return n;
}

ScreenPoint normalized_to_screen(Normalized n, Resolution screen)
{
    ScreenPoint p;
    p.x = screen.width * n.s;
    p.y = screen.height - screen.height * n.t;
    return p;
}

ScreenPoint pixel_center(Pixel pixel)
{
    ScreenPoint p = {(2 * pixel.column + 1) / 2.0, (2 * pixel.row + 1) / 2.0};
    return p;
}
