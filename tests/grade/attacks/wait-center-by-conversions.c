// wait-center-by-conversions: a pixel's centre from there and back again, both placeholders.
// stem: 03-screen
// expect: graded
// earns: nothing
#include "exercises/03-screen.h"

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    return (Normalized){point.x, screen.height - point.y};
}

ScreenPoint normalized_to_screen(Normalized place, Resolution screen)
{
    return (ScreenPoint){place.s, place.t + screen.width};
}

ScreenPoint pixel_center(Pixel pixel)
{
    Resolution screen = {2, 2};
    ScreenPoint half = normalized_to_screen((Normalized){0.25, 0.75}, screen);
    return (ScreenPoint){pixel.column + half.x, pixel.row + half.y};
}
