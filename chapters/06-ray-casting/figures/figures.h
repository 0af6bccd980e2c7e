// figures.h - the figures of chapter 06.
#ifndef CHAPTERS_06_RAY_CASTING_FIGURES_FIGURES_H
#define CHAPTERS_06_RAY_CASTING_FIGURES_FIGURES_H

#include "chapters/06-ray-casting/figures/shown.h"

// The scene that a figure shows by default, as a path from the top of the project; for "", the
// chapter's own.
const char *figure_scene(const char *name);

// The pixel of that scene; column -1 means any pixel.
Pixel figure_pixel(const char *name);

// Prints a figure's script; returns the result of main.
int casting_figure(const char *program, FigureCommand command, Shot shot);

#endif
