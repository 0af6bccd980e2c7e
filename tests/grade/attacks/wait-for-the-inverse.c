// wait-for-the-inverse: a conversion by its inverse, which is blank.
// stem: 03-screen
// expect: graded
// earns: nothing
#include "exercises/03-screen.h"

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    ScreenPoint zero = normalized_to_screen((Normalized){0, 0}, screen);
    ScreenPoint one = normalized_to_screen((Normalized){1, 1}, screen);
    return (Normalized){(point.x - zero.x) / (one.x - zero.x),
                        (point.y - zero.y) / (one.y - zero.y)};
}
