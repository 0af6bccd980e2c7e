// nearest_figure.h - one ray and what it meets, flat, as a figure's data.
#ifndef CHAPTERS_06_RAY_CASTING_FIGURES_NEAREST_FIGURE_H
#define CHAPTERS_06_RAY_CASTING_FIGURES_NEAREST_FIGURE_H

#include "chapters/06-ray-casting/figures/shown.h"

// Each sphere is turned round the ray into the paper; lengths are counted in the ray's t. given is
// a Shown.
void nearest_figure_data(Plot *plot, void *given);

#endif
