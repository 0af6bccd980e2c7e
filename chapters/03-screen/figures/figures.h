// figures.h - the figures of chapter 03.
#ifndef CHAPTERS_03_SCREEN_FIGURES_FIGURES_H
#define CHAPTERS_03_SCREEN_FIGURES_FIGURES_H

#include "common/figure/plot.h"
#include "common/screen.h"

// What they show: a point and a pixel of a screen.
typedef struct {
    Resolution screen;
    ScreenPoint point;
    Pixel pixel;
} Spot;

extern const Figure screen_figures[];

#endif
