// clipped_circle.h - the part of a circle within a rectangle, for circles that are too large for
// the paper.
#ifndef CHAPTERS_06_RAY_CASTING_FIGURES_CLIPPED_CIRCLE_H
#define CHAPTERS_06_RAY_CASTING_FIGURES_CLIPPED_CIRCLE_H

#include <stdbool.h>

typedef struct {
    double low[2], high[2];
} Window;

typedef struct {
    double at[2];
    bool on_circle; // if not, it is on the window's edge
} Place;

enum { ARC_PLACES = 512, MOST_PLACES = ARC_PLACES + 16 };

// The corners of the part of the disc in the window, in order; returns their number.
int window_part(Window window, const double middle[2], double radius, Place places[MOST_PLACES]);

#endif
