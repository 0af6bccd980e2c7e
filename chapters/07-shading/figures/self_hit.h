// self_hit.h - why a ray must not start on the surface that it leaves, as the data of a figure.
#ifndef CHAPTERS_07_SHADING_FIGURES_SELF_HIT_H
#define CHAPTERS_07_SHADING_FIGURES_SELF_HIT_H

#include "common/figure/plot.h"

void self_hit_data(Plot *plot, void *given);

#endif
