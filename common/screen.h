// screen.h - screen coordinates: pixel, point, normalized.
//
// Each has its own type, so that the compiler does not let you use one for another. Mapping
// between them is exercise 03.
#ifndef COMMON_SCREEN_H
#define COMMON_SCREEN_H

// The size of a screen or an image, in pixels; both at least 1.
typedef struct {
    int width, height;
} Resolution;

// A pixel: column from the left, row from the top, both from 0. It is a square; its
// center represents it.
typedef struct {
    int column, row;
} Pixel;

// A point on the screen, in pixels, continuous: origin at the upper left, x to the right, y down.
// The screen is 0..width by 0..height, so (0, 0) is the outer corner of the first pixel.
typedef struct {
    double x, y;
} ScreenPoint;

// Normalized coordinates: the whole screen is 0..1 by 0..1, origin at the lower left, s to the
// right, t up. The letters are the slide's.
typedef struct {
    double s, t;
} Normalized;

// A part of the screen between two columns and two rows of points: x from left to right, y from top
// to bottom.
typedef struct {
    double left, right, top, bottom;
} ScreenRectangle;

#endif
