#include "exercises/03-screen.h"

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    return (Normalized){point.x / screen.width, 1 - point.y / screen.height};
}

ScreenPoint normalized_to_screen(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width, screen.height - place.t * screen.height};
}

ScreenPoint pixel_center(Pixel pixel)
{
    ScreenPoint p;
    p.x = pixel.column;
    p.y = pixel.row;
    return p;
}
