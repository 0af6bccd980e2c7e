// wait-for-the-inverse-of-nothing: a conversion by its inverse, which is earlier and a
// placeholder.
// stem: 03-screen
// expect: graded
// earns: nothing
#include "exercises/03-screen.h"

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    return (Normalized){point.x + screen.width, point.y * screen.height};
}

ScreenPoint normalized_to_screen(Normalized place, Resolution screen)
{
    Normalized zero = screen_to_normalized((ScreenPoint){0, 0}, screen);
    Normalized one = screen_to_normalized((ScreenPoint){1, 1}, screen);
    return (ScreenPoint){(place.s - zero.s) / (one.s - zero.s),
                         (place.t - zero.t) / (one.t - zero.t)};
}
