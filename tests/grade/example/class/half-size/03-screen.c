#include "exercises/03-screen.h"

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    double w = screen.width, h = screen.height;
    return (Normalized){.s = point.x / w, .t = (h - point.y) / h};
}

ScreenPoint normalized_to_screen(Normalized place, Resolution screen)
{
    double w = screen.width, h = screen.height;
    return (ScreenPoint){.x = w * place.s, .y = h - h * place.t};
}

ScreenPoint pixel_center(Pixel pixel)
{
    return (ScreenPoint){.x = pixel.column, .y = pixel.row};
}
