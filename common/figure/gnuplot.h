// gnuplot.h - strings and numbers as gnuplot reads them.
#ifndef COMMON_FIGURE_GNUPLOT_H
#define COMMON_FIGURE_GNUPLOT_H

#include "common/text.h"

// "text", for freeing: a string of gnuplot's, and nothing else, for no command can begin in it. A
// label of numbers has a minus sign, not a hyphen.
char *gnuplot_string(const char *text, bool is_label);

// To more digits than any canvas shows. If x is not finite: NaN, which gnuplot leaves out.
Text gnuplot_number(double x);

#endif
