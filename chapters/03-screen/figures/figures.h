// figures.h - the figures of chapter 03.
#ifndef CHAPTERS_03_SCREEN_FIGURES_FIGURES_H
#define CHAPTERS_03_SCREEN_FIGURES_FIGURES_H

#include "common/figure/plot.h"
#include "common/screen.h"

// A point and a pixel of a screen.
typedef struct {
    Resolution screen;
    ScreenPoint point;
    Pixel pixel;
} Spot;

// Prints a figure's script. Returns the exit status for main.
int screen_figure(const char *program, FigureCommand command, const Spot *spot);

#endif
