// window.h - what of a circle is within a rectangle, for circles too large for the paper.
#ifndef CHAPTERS_06_RAY_CASTING_FIGURES_WINDOW_H
#define CHAPTERS_06_RAY_CASTING_FIGURES_WINDOW_H

#include <stdbool.h>

typedef struct {
    double low[2], high[2];
} Window;

typedef struct {
    double at[2];
    bool on_circle; // else on the window's edge
} Place;

enum { ARC_PLACES = 512, MOST_PLACES = ARC_PLACES + 16 };

// The corners of what the window shows of the disc, in order; returns how many.
int window_part(Window window, const double middle[2], double radius, Place places[MOST_PLACES]);

#endif
