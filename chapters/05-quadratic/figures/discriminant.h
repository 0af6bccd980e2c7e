// discriminant.h - five rays and a sphere: the discriminant and the signs of the roots.
#ifndef CHAPTERS_05_QUADRATIC_FIGURES_DISCRIMINANT_H
#define CHAPTERS_05_QUADRATIC_FIGURES_DISCRIMINANT_H

#include "common/figure/plot.h"

// The data of that figure; given is a Meeting, and only its radius is used.
void discriminant_figure(Plot *plot, void *given);

// The same with one panel for each moment of a ray that moves from each of the five places to the
// next, and stays there for a while ($stays).
void discriminant_moments(Plot *plot, void *given);

#endif
