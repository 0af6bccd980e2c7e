// plot.c - figures: what layouts call by name: numbers, words, points, vectors, pairs.
#include "common/figure/gnuplot.h"
#include "common/figure/plot_internal.h"

#include <stdlib.h>
#include <string.h>

enum { LABEL_DIGITS = 4 };

// Where something else is right, that goes by the name, and yours by your_NAME.
static void define_both(Plot *plot, const char *name, const char *value, bool is_wrong)
{
    const char *right;
    size_t size = plot_right_value(plot, name, &right);
    if (size > 0)
        fprintf(plot->script, "%s = %.*s\n", name, (int)size, right);
    if (size == 0 || is_wrong)
        fprintf(plot->script, "%s%s = %s\n", size > 0 ? "your_" : "", name, value);
    plot->wrong = plot->wrong || (size > 0 && is_wrong);
    plot_view_words(plot, name, size > 0 ? right : value, size > 0 ? size : strlen(value));
    if (size > 0 && is_wrong) {
        char yours[100];
        snprintf(yours, sizeof yours, "your_%s", name);
        plot_view_words(plot, yours, value, strlen(value));
    }
}

// Whether it differs from what is right.
static bool define(Plot *plot, const char *name, const char *value)
{
    const char *right;
    size_t size = plot_right_value(plot, name, &right);
    bool is_wrong = size > 0 && !plot_is_right(right, size, value);
    define_both(plot, name, value, is_wrong);
    return is_wrong;
}

// It is wrong if its numbers are: a 0 that is off by rounding also has another text.
static void define_label(Plot *plot, const char *name, const char *label, bool is_wrong)
{
    char key[100], *value = gnuplot_string(label, true);
    snprintf(key, sizeof key, "%s_text", name);
    define_both(plot, key, value, is_wrong);
    free(value);
}

// ---- numbers and words ------------------------------------------------------------------------

void plot_number_to(Plot *plot, const char *name, double x, int digits)
{
    bool is_wrong = define(plot, name, gnuplot_number(x).s);
    define_label(plot, name, number_text_to(x, digits).s, is_wrong);
}

void plot_number(Plot *plot, const char *name, double x)
{
    plot_number_to(plot, name, x, LABEL_DIGITS);
}

static void define_text(Plot *plot, const char *name, const char *text, bool is_label)
{
    char *value = gnuplot_string(text, is_label);
    define(plot, name, value);
    free(value);
}

void plot_text(Plot *plot, const char *name, const char *text)
{
    define_text(plot, name, text, false);
}

void plot_label(Plot *plot, const char *name, const char *label)
{
    char key[100];
    snprintf(key, sizeof key, "%s_text", name);
    define_text(plot, key, label, true);
}

// ---- points and vectors -----------------------------------------------------------------------

void plot_point(Plot *plot, const char *name, vec3 point)
{
    plot_block(plot, name, "x y z");
    plot_row_point(plot, point);
    bool is_wrong = plot_block_end(plot);
    define_label(plot, name, vec3_text_to(point, LABEL_DIGITS).s, is_wrong);
    if (is_wrong)
        plot_fit_wrong(plot, point);
}

void plot_vector(Plot *plot, const char *name, vec3 from, vec3 vector)
{
    plot_block(plot, name, "x y z of its start, x y z of the vector");
    plot_row_vector(plot, from, vector);
    bool is_wrong = plot_block_end(plot);
    define_label(plot, name, vec3_text_to(vector, LABEL_DIGITS).s, is_wrong);
    if (is_wrong)
        plot_fit_wrong(plot, from + vector);
}

void plot_direction(Plot *plot, const char *name, vec3 v)
{
    static const char axes[] = "xyz";
    bool is_wrong = false;
    for (int i = 0; i < 3; i++) {
        char key[100];
        snprintf(key, sizeof key, "%s_%c", name, axes[i]);
        bool differs = define(plot, key, gnuplot_number(v[i]).s);
        is_wrong = is_wrong || differs;
    }
    define_label(plot, name, vec3_text_to(v, LABEL_DIGITS).s, is_wrong);
}

// ---- pairs of numbers -------------------------------------------------------------------------

static void define_part(Plot *plot, const char *name, const char *part, double x)
{
    char key[100];
    snprintf(key, sizeof key, "%s_%s", name, part);
    plot_number_to(plot, key, x, TEXT_DIGITS);
}

void plot_pair(Plot *plot, const char *name, const char *first_name, double first,
               const char *second_name, double second)
{
    char columns[100];
    snprintf(columns, sizeof columns, "%s %s", first_name, second_name);
    plot_block(plot, name, columns);
    plot_row(plot, 2, (const double[]){first, second});
    bool is_wrong = plot_block_end(plot);
    define_label(plot, name, pair_text(first, second).s, is_wrong);
    define_part(plot, name, first_name, first);
    define_part(plot, name, second_name, second);
}
