// rectangles.h - where the spheres of a scene are on the screen: in numbers, and as the figure of
// chapter 08.
#ifndef CHAPTERS_08_FAST_RECTANGLES_H
#define CHAPTERS_08_FAST_RECTANGLES_H

#include "chapters/shared/scene_command.h"
#include "common/figure/plot.h"

// Each returns the result of main.

// Prints the rectangle of each sphere, and how many questions the rectangles save.
int rectangles_tell(const char *program, const Command *command);

// What the command line says of the figure: a sphere from above, and the two lines that touch it.
typedef struct {
    FigureCommand command;
    Sphere sphere; // radius 0: the first of the scene
} RectangleFigure;

#define RECTANGLE_FIGURE_OPTIONS(figure)                                                           \
    {"center", 0, "X,Y,Z", option_vec3, &(figure).sphere.center, NULL},                            \
        {"radius", 0, "R", option_number, &(figure).sphere.radius, NULL},                          \
        FIGURE_OPTIONS((figure).command)

// Prints the figure's script.
int rectangle_figure(const char *program, const RectangleFigure *figure, const Command *command);

// Both as a program: reads the scene and the size from the command line.
int rectangles_command(int argc, char **argv);

#endif
