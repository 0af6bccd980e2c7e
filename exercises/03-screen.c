// 03-screen.c - exercise 03: screen coordinates.
//
// Your answers go between BEGIN SOLUTION and END SOLUTION; helper functions may go anywhere.
// Questions and rules: exercises/03-screen.h. The lesson: chapters/03-screen/README.md.
// After each change:   make exercises EX=03
#include "exercises/03-screen.h"

#include "common/answers.h"

Normalized screen_to_normalized(ScreenPoint point, Resolution screen)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(Normalized);
    // END SOLUTION
}

ScreenPoint normalized_to_screen(Normalized normalized, Resolution screen)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(ScreenPoint);
    // END SOLUTION
}

ScreenPoint pixel_center(Pixel pixel)
{
    // BEGIN SOLUTION
    return NOT_ANSWERED(ScreenPoint);
    // END SOLUTION
}
