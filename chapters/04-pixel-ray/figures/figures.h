// figures.h - the figure of chapter 04.
#ifndef CHAPTERS_04_PIXEL_RAY_FIGURES_FIGURES_H
#define CHAPTERS_04_PIXEL_RAY_FIGURES_FIGURES_H

#include "common/camera.h"
#include "common/figure/plot.h"
#include "common/screen.h"

// A pixel of a screen, seen by a camera.
typedef struct {
    Camera camera;
    Resolution screen;
    Pixel pixel;
} Aim;

// Prints a figure's script. Returns the exit status for main.
int pixel_ray_figure(const char *program, FigureCommand command, const Aim *aim);

#endif
