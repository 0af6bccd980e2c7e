// figures.h - the figures of chapter 01.
#ifndef CHAPTERS_01_CORNERS_FIGURES_H
#define CHAPTERS_01_CORNERS_FIGURES_H

#include "common/camera.h"
#include "common/plot.h"

// A camera, and a place on its image plane.
typedef struct {
    Camera camera;
    double s, t;
} View;

// Prints a figure's script; returns what main returns.
int corners_figure(const char *program, FigureCommand command, const View *view);

#endif
