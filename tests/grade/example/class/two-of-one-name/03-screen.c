#include "exercises/03-screen.h"

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    Normalized place = {point.x, -point.y};
    place.s /= screen.width;
    place.t /= screen.height;
    place.t += 1;
    return place;
}

ScreenPoint pixel_center(Pixel pixel)
{
    return (ScreenPoint){pixel.column + .5, pixel.row + .5};
}
