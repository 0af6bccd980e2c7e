// 03-screen.h - exercise 03: places on the screen.
//
// Slide 'Normalized screen coordinates'. The screen has its origin at the upper left, y down;
// normalized coordinates have theirs at the lower left, t up (screen.h).
// Scale: on a screen of k times as many pixels the same shares are k times as many pixels. Tests
// use screens of any shape, from a single column or row to a million pixels.
// Tolerance: 1e-12 normalized, 1e-9 of a pixel.
#ifndef EXERCISES_03_SCREEN_H
#define EXERCISES_03_SCREEN_H

#include "common/screen.h"

// "What are the point's normalized screen coordinates?" (0, 0) at the lower left of the screen,
// (1, 1) at the upper right. Points beyond the screen are beyond 0..1.
Normalized screen_to_normalized(ScreenPoint point, Resolution screen);

// And back.
ScreenPoint normalized_to_screen(Normalized place, Resolution screen);

// The point that stands for a pixel: its centre.
ScreenPoint pixel_center(Pixel pixel);

#endif
