// nearest_figure.h - one ray and the spheres that it meets, in a plane, as the data of a figure.
#ifndef CHAPTERS_06_RAY_CASTING_FIGURES_NEAREST_FIGURE_H
#define CHAPTERS_06_RAY_CASTING_FIGURES_NEAREST_FIGURE_H

#include "chapters/06-ray-casting/figures/shown.h"

// Each sphere is turned around the ray into the paper; lengths are measured in the ray's t. given
// is a Shown.
void nearest_figure_data(Plot *plot, void *given);

#endif
