// figures.h - the figures of chapter 07.
#ifndef CHAPTERS_07_SHADING_FIGURES_H
#define CHAPTERS_07_SHADING_FIGURES_H

#include "chapters/06-ray-casting/command.h"
#include "common/plot.h"

// Prints a figure's script; returns what main returns. The scene of a drawing, or the chapter's
// own.
int shading_figure(FigureCommand command, const Drawing *drawing);

#endif
