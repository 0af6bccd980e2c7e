#include "exercises/03-screen.h"

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    return (Normalized){point.x / screen.width, 1.0 - point.y / screen.height};
}

// inverse of the above: x = s * W, y = (1 - t) * H
ScreenPoint normalized_to_screen(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s * screen.width, (1.0 - place.t) * screen.height};
}

ScreenPoint pixel_center(Pixel pixel)
{
    return (ScreenPoint){0.5 + pixel.column, 0.5 + pixel.row};
}
