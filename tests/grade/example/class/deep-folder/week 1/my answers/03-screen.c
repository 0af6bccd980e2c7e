#include "exercises/03-screen.h"

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    return (Normalized){point.x / screen.width, (screen.height - point.y) / screen.height};
}

ScreenPoint normalized_to_screen(Normalized place, Resolution screen)
{
    return (ScreenPoint){screen.width * place.s, screen.height * (1 - place.t)};
}

ScreenPoint pixel_center(Pixel pixel)
{
    return (ScreenPoint){pixel.column + 1 / 2.0, pixel.row + 1 / 2.0};
}
