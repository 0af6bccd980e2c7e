// discriminant.h - five rays and a sphere: what the discriminant and the signs of the roots say.
#ifndef CHAPTERS_05_QUADRATIC_FIGURES_DISCRIMINANT_H
#define CHAPTERS_05_QUADRATIC_FIGURES_DISCRIMINANT_H

#include "common/figure/plot.h"

// The data of that figure; given is a Meeting, of which only the radius counts.
void discriminant_figure(Plot *plot, void *given);

#endif
