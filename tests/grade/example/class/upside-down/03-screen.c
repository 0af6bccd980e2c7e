#include "exercises/03-screen.h"

#include "common/answers.h"

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    // BEGIN SOLUTION
    return (Normalized){point.x / screen.width, point.y / screen.height};
    // END SOLUTION
}

ScreenPoint normalized_to_screen(Normalized place, Resolution screen)
{
    // BEGIN SOLUTION
    return (ScreenPoint){place.s * screen.width, place.t * screen.height};
    // END SOLUTION
}

ScreenPoint pixel_center(Pixel pixel)
{
    // BEGIN SOLUTION
    return (ScreenPoint){pixel.column + 0.5, pixel.row + 0.5};
    // END SOLUTION
}
