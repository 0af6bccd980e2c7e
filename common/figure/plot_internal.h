// plot_internal.h - a figure's script while it is collected: shared by the files that implement
// plot.h.
#ifndef COMMON_FIGURE_PLOT_INTERNAL_H
#define COMMON_FIGURE_PLOT_INTERNAL_H

#include "common/figure/plot.h"
#include "common/text.h"

typedef struct PlotView PlotView;

enum { MOST_HANDLES = 12 };

struct Plot {
    FILE *script;
    FILE *included; // the text before the data
    FILE *rows;     // of the block that is being written
    char *rows_text;
    size_t rows_size;
    char block[60], columns[120];
    char *right;                  // the data by right answers; NULL if there are none
    bool wrong;                   // something differs from them
    PlotView *view;               // from where it is seen, and its labels
    Handle handles[MOST_HANDLES]; // those that are typed are the last
    int handle_count;
    bool is_live;
    bool is_moved;  // a handle is: the options that put it there are asked for, not the script
    FILE *pictures; // where pictures go; NULL: into the script
    FILE *strip;    // the paragraphs below the canvas
    int paragraphs;
    bool failed; // a file could not be read, and a message said so
};

// ---- strings and numbers as gnuplot reads them (plot.c) -----------------------------------------

// "text", for freeing: a string of gnuplot's, and nothing else, for no command can begin in it.
char *gnuplot_string(const char *text);

// To more digits than any canvas shows. If x is not finite: NaN, which gnuplot leaves out.
Text gnuplot_number(double x);

// ---- words of a lecturer's own (own_words.c) ----------------------------------------------------

// What is said instead of an English text: printed, or for freeing. And for layouts (plot.gp: own).
void own_words_print(FILE *out, const char *text, size_t length);
char *own_words(const char *text);
void own_words_define(FILE *out);

// ---- what is right (plot.c) -------------------------------------------------------------------

// The right value of NAME, and the right rows of a block, here without '$' before its name. Returns
// how many characters begin there; 0 where there are none.
size_t plot_right_value(const Plot *plot, const char *name, const char **begin);
size_t plot_right_rows(const Plot *plot, const char *block, const char **begin);

// A block ends, if one has begun; returns whether it differs from what is right.
bool plot_block_end(Plot *plot);

// ---- from where it is seen (plot_view.c) --------------------------------------------------------

PlotView *plot_view_new(void);
void plot_view_free(PlotView *view);

// A block begins; a row of it is a place, and what is drawn from there (0: nothing); it ends, and
// these are its right rows, if there are any.
void plot_view_block(Plot *plot);
void plot_view_row(Plot *plot, vec3 from, vec3 vector);
void plot_view_gap(Plot *plot);
void plot_view_block_end(Plot *plot, const char *right, size_t size);

// Writes $fit, when all else is written: what is right has to be seen, and of what is wrong the
// parts that are near enough to leave the rest of the figure legible.
void plot_view_fits_end(Plot *plot);

// What the words of a name are.
void plot_view_words(Plot *plot, const char *name, const char *value, size_t size);

// Places the labels, and writes the places, when all else is written. Returns whether the figure
// says from where it is seen.
bool plot_view_end(Plot *plot);

// Only this shape is placed: 0 is 16:9, 1 is 4:3.
void plot_view_only(Plot *plot, int shape);

// The view as text, and the same again: scale and place of each panel, so that nothing moves while
// a handle is dragged. False if that is no view.
bool plot_view_hold(Plot *plot, const char *text);
void plot_view_print(const Plot *plot, FILE *out);
bool plot_view_is_held(const Plot *plot);

// The panel that is chosen; a place of the world on the canvas; how a way goes there. False if the
// figure does not say from where it is seen.
int plot_view_panel(const Plot *plot);
bool plot_view_spot(const Plot *plot, int panel, vec3 place, double uv[2]);
void plot_view_way(const Plot *plot, int panel, vec3 way, double uv[2]);

// ---- what can be dragged (plot_handle.c) --------------------------------------------------------

// As JSON: the handles and where they are, the numbers to be typed, the view.
void plot_handles_print(const Plot *plot, FILE *out);

// As JSON: the options that put a handle there, "HANDLE,U,V". False, and a message on stderr, if
// there is no such handle.
bool plot_handles_drag(const Plot *plot, const char *drag, FILE *out);

#endif
