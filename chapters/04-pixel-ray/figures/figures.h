// figures.h - the figure of chapter 04.
#ifndef CHAPTERS_04_PIXEL_RAY_FIGURES_FIGURES_H
#define CHAPTERS_04_PIXEL_RAY_FIGURES_FIGURES_H

#include "common/camera.h"
#include "common/figure/plot.h"
#include "common/screen.h"

// What it shows: a pixel of a screen, seen by a camera.
typedef struct {
    Camera camera;
    Resolution screen;
    Pixel pixel;
} Aim;

extern const Figure pixel_ray_figures[];

#endif
