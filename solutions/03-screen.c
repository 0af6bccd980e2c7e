// 03-screen.c - exercise 03: screen coordinates.
//
// Your answers go between BEGIN SOLUTION and END SOLUTION; helper functions may go anywhere.
// Questions and rules: exercises/03-screen.h. The lesson: chapters/03-screen/README.md.
// After each change:   make exercises EX=03
#include "exercises/03-screen.h"

#include "common/answers.h"

// BEGIN SOLUTION
// Divide by the size, and flip the vertical axis: y counts down, t counts up.
// END SOLUTION

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(Normalized);
    return (Normalized){point.x / screen.width, 1 - point.y / screen.height};
    // END SOLUTION
}

ScreenPoint normalized_to_screen(Normalized normalized, Resolution screen)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(ScreenPoint);
    return (ScreenPoint){normalized.s * screen.width, (1 - normalized.t) * screen.height};
    // END SOLUTION
}

ScreenPoint pixel_center(Pixel pixel)
{
    // BEGIN SOLUTION
    //~ return NOT_ANSWERED(ScreenPoint);
    return (ScreenPoint){pixel.column + 0.5, pixel.row + 0.5};
    // END SOLUTION
}
