// own_figure.h - the numbers of a figure of your own, when no chapter's figure has them.
//
// Beside the layout my-figures/NAME.gp, whose first line is '# data: FILE.c', FILE.c includes this
// header and defines figure_data. 'make figures FIGURES=my-figures' compiles it with the answers
// and with everything in common/, and main is here.
#ifndef CHAPTERS_SHARED_OWN_FIGURE_H
#define CHAPTERS_SHARED_OWN_FIGURE_H

#include "common/figure/plot.h"

// Yours: gives the layout its numbers, points, vectors and tables (common/figure/plot.h).
void figure_data(Plot *plot);

#endif
