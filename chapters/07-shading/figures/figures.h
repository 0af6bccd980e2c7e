// figures.h - the figures of chapter 07.
#ifndef CHAPTERS_07_SHADING_FIGURES_FIGURES_H
#define CHAPTERS_07_SHADING_FIGURES_FIGURES_H

#include "chapters/shared/render.h"
#include "chapters/shared/scene_command.h"
#include "common/figure/plot.h"

// Of the closing slide, as a figure and as a picture: smooth edges, and no mirrors, as in the deck.
extern const Style closing_style;

// Prints a figure's script; returns the result of main. The scene is that of a drawing, or the
// chapter's own.
int shading_figure(FigureCommand command, const Drawing *drawing);

#endif
