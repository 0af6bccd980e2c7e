// figures.h - the figure of chapter 08: a sphere from above, and the two lines that touch it.
#ifndef CHAPTERS_08_FAST_FIGURES_FIGURES_H
#define CHAPTERS_08_FAST_FIGURES_FIGURES_H

#include "chapters/shared/scene_command.h"
#include "common/figure/plot.h"

// What the command line says of it.
typedef struct {
    FigureCommand command;
    Sphere sphere; // radius 0: the first of the scene
} RectangleFigure;

#define RECTANGLE_FIGURE_OPTIONS(figure)                                                           \
    {"center", 0, "X,Y,Z", option_vec3, &(figure).sphere.center, NULL},                            \
        {"radius", 0, "R", option_number, &(figure).sphere.radius, NULL},                          \
        FIGURE_OPTIONS((figure).command)

// Prints the figure's script; returns the result of main.
int rectangle_figure(const char *program, const RectangleFigure *figure, const Command *command);

#endif
