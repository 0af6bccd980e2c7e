// plot_internal.h - a figure's script while it is collected: shared by the files that implement
// plot.h.
#ifndef COMMON_FIGURE_PLOT_INTERNAL_H
#define COMMON_FIGURE_PLOT_INTERNAL_H

#include "common/figure/plot.h"

struct Plot {
    FILE *script;
    FILE *included; // the text before the data
    FILE *fit;      // rows of $fit
    char *fit_text;
    size_t fit_size;
    FILE *rows; // of the block that is being written
    char *rows_text;
    size_t rows_size;
    const char *block;
    const char *columns;
    char *right; // the data by right answers; NULL if there are none
    bool wrong;  // something differs from them
    bool failed; // a file could not be read, and a message said so
};

// ---- what is right (plot_right.c) -------------------------------------------------------------

// The right value of NAME, and the right rows of a block, here without '$' before its name. Returns
// how many characters begin there; 0 where there are none.
size_t plot_right_value(const Plot *plot, const char *name, const char **begin);
size_t plot_right_rows(const Plot *plot, const char *block, const char **begin);

// So many characters of what is right, and yours: the same words, and the same numbers as far as
// rounding goes?
bool plot_is_right(const char *right, size_t size, const char *yours);

// ---- what has to be seen (plot_fit.c) ---------------------------------------------------------

// Shows a wrong part, if it is near enough to leave the rest of the figure legible.
void plot_fit_wrong(Plot *plot, vec3 place);

// Writes $fit, when all else is written.
void plot_fit_end(Plot *plot);

#endif
