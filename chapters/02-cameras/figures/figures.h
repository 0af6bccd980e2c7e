// figures.h - the figures of chapter 02.
#ifndef CHAPTERS_02_CAMERAS_FIGURES_FIGURES_H
#define CHAPTERS_02_CAMERAS_FIGURES_FIGURES_H

#include "common/camera.h"
#include "common/figure/plot.h"

// Prints a figure's script. up is the up vector of a look-at, or the camera's own; lean is the up
// that the figure look-at begins with, or NaN. Returns the exit status for main.
int cameras_figure(const char *program, FigureCommand command, Camera camera, vec3 up, vec3 lean);

#endif
