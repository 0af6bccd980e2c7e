// 03-screen.h - exercise 03: screen coordinates.
//
// Slide 'Normalized screen coordinates'. The origin of the screen is at the upper left, and y
// counts down. The origin of normalized coordinates is at the lower left, and t counts up
// (screen.h). Scale: if the screen has k times as many pixels, x and y are k times as large, and s
// and t are the same. Tests use screens of any shape, from a single column or row to a million
// pixels. Tolerance: 1e-12 for normalized coordinates, 1e-9 of a pixel for points.
#ifndef EXERCISES_03_SCREEN_H
#define EXERCISES_03_SCREEN_H

#include "common/screen.h"

// "What are the point's normalized screen coordinates?" Returns (0, 0) for the lower left corner of
// the screen and (1, 1) for the upper right corner. For a point outside the screen, s or t is
// outside 0..1.
Normalized screen_to_normalized(ScreenPoint point, Resolution screen);

// Returns the point on the screen that has these normalized coordinates.
ScreenPoint normalized_to_screen(Normalized normalized, Resolution screen);

// Returns the point that stands for a pixel: its center.
ScreenPoint pixel_center(Pixel pixel);

#endif
