// figures.h - the figures of chapter 06.
#ifndef CHAPTERS_06_RAY_CASTING_FIGURES_FIGURES_H
#define CHAPTERS_06_RAY_CASTING_FIGURES_FIGURES_H

#include "chapters/06-ray-casting/figures/shown.h"

// The scene that a figure shows where none is named, by its path from the top of the project.
const char *figure_scene(const char *name);

// The pixel of that scene; column -1: any.
Pixel figure_pixel(const char *name);

// Prints a figure's script; returns what main returns.
int casting_figure(const char *program, FigureCommand command, Shot shot);

#endif
