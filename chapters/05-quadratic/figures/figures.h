// figures.h - the figures of chapter 05.
#ifndef CHAPTERS_05_QUADRATIC_FIGURES_FIGURES_H
#define CHAPTERS_05_QUADRATIC_FIGURES_FIGURES_H

#include "common/figure/plot.h"
#include "common/ray.h"
#include "common/sphere.h"

// A ray and a sphere.
typedef struct {
    Ray ray;
    Sphere sphere;
} Meeting;

// Prints a figure's script; returns the result of main.
int quadratic_figure(const char *program, FigureCommand command, const Meeting *meeting);

#endif
