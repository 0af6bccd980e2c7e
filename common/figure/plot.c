// plot.c - the data of a figure: tables, which gnuplot calls data blocks, and what layouts call by
// name: numbers, words, points, vectors, pairs. Beside them is what is right, if that is known.
#include "common/figure/plot_internal.h"

#include <stdlib.h>
#include <string.h>

// ---- strings and numbers as gnuplot reads them --------------------------------------------------

char *gnuplot_string(const char *text)
{
    char *string;
    size_t size;
    FILE *out = open_memstream(&string, &size);
    putc('"', out);
    for (; *text != '\0'; text++) {
        if (*text == '"' || *text == '\\')
            putc('\\', out);
        // A backquote would run what is between two of them.
        putc((unsigned char)*text < ' ' ? ' ' : *text == '`' ? '\'' : *text, out);
    }
    putc('"', out);
    fclose(out);
    return string;
}

Text gnuplot_number(double x)
{
    enum { DIGITS = 12 };
    return isfinite(x) ? number_text_to(x, DIGITS) : (Text){"NaN"};
}

// ---- the data by right answers, and whether yours say the same ----------------------------------

// From the end of key, which begins a line, up to end.
static size_t between(const Plot *plot, const char *key, const char *end, const char **begin)
{
    const char *found = plot->right != NULL ? strstr(plot->right, key) : NULL;
    if (found == NULL)
        return 0;
    *begin = found + strlen(key);
    const char *stop = strstr(*begin, end);
    return stop != NULL ? (size_t)(stop - *begin) : 0;
}

size_t plot_right_value(const Plot *plot, const char *name, const char **begin)
{
    return between(plot, text_of("\n%s = ", name).s, "\n", begin);
}

// After the block's first line comes the comment that names its columns.
size_t plot_right_rows(const Plot *plot, const char *block, const char **begin)
{
    size_t size = between(plot, text_of("\n$%s << EOD\n", block).s, "\nEOD\n", begin);
    const char *line = size > 0 ? strchr(*begin, '\n') : NULL;
    if (line == NULL)
        return 0;
    size++; // the last row's end
    size -= (size_t)(line + 1 - *begin);
    *begin = line + 1;
    return size;
}

static bool is_right(const char *right, size_t size, const char *yours)
{
    const char *end = right + size;
    while (right < end && *yours != '\0') {
        char *right_next, *yours_next;
        double x = strtod(right, &right_next), y = strtod(yours, &yours_next);
        if ((right_next == right) != (yours_next == yours))
            return false;
        if (right_next == right) {
            if (*right++ != *yours++)
                return false;
            continue;
        }
        if (!(x == y || fabs(x - y) <= 1e-9 * (1 + fabs(x)) || (isnan(x) && isnan(y))))
            return false;
        right = right_next;
        yours = yours_next;
    }
    return right >= end && *yours == '\0';
}

// ---- tables -------------------------------------------------------------------------------------

void plot_block(Plot *plot, const char *name, const char *columns)
{
    plot_block_end(plot);
    snprintf(plot->block, sizeof plot->block, "%s", name);
    snprintf(plot->columns, sizeof plot->columns, "%s", columns);
    plot->rows = open_memstream(&plot->rows_text, &plot->rows_size);
    plot_view_block(plot);
}

void plot_row_of(Plot *plot, int count, const double *numbers)
{
    for (int i = 0; i < count; i++)
        fprintf(plot->rows, "%s%s", i > 0 ? " " : "", gnuplot_number(numbers[i]).s);
    putc('\n', plot->rows);
}

void plot_row_at_of(Plot *plot, vec3 place, int count, const double *numbers)
{
    for (int i = 0; i < 3; i++)
        fprintf(plot->rows, "%s%s", gnuplot_number(place[i]).s, i < 2 || count > 0 ? " " : "");
    plot_row_of(plot, count, numbers);
}

void plot_row_point(Plot *plot, vec3 point)
{
    plot_view_row(plot, point, vec3_of(0, 0, 0));
    plot_row_at_of(plot, point, 0, NULL);
}

void plot_row_vector(Plot *plot, vec3 from, vec3 vector)
{
    plot_view_row(plot, from, vector);
    plot_row_at(plot, from, vector[0], vector[1], vector[2]);
}

void plot_row_dot_of(Plot *plot, vec3 place, int count, const double *numbers)
{
    plot_view_gap(plot);
    plot_view_row(plot, place, vec3_of(0, 0, 0));
    plot_row_at_of(plot, place, count, numbers);
}

void plot_gap(Plot *plot)
{
    putc('\n', plot->rows);
    plot_view_gap(plot);
}

static bool has_rows(const char *rows)
{
    while (*rows != '\0') {
        size_t length = strcspn(rows, "\n");
        const char *none = strstr(rows, "NaN");
        if (length > 0 && (none == NULL || none > rows + length))
            return true;
        rows += length + (rows[length] == '\n');
    }
    return false;
}

// Takes rows over. Of a block that has no row, or none without a NaN, as many far off the canvas,
// at least one: gnuplot 5.4 warns of the one, and crashes on labels of the other.
static char *drawable(char *rows)
{
    if (has_rows(rows))
        return rows;
    char *text;
    size_t size;
    FILE *instead = open_memstream(&text, &size);
    const char *row = rows;
    do {
        fputs("1e9 1e9 1e9 1e9 1e9 1e9 1e9 1e9 1e9 1e9 1e9 1e9\n", instead);
        row = strchr(row, '\n');
    } while (row != NULL && *++row != '\0');
    fclose(instead);
    free(rows);
    return text;
}

bool plot_block_end(Plot *plot)
{
    if (plot->rows == NULL)
        return false;
    fclose(plot->rows);
    plot->rows = NULL;
    char *yours = drawable(plot->rows_text);
    fprintf(plot->script, "$%s << EOD\n# %s\n", plot->block, plot->columns);
    const char *right;
    size_t size = plot_right_rows(plot, plot->block, &right);
    bool is_wrong = size > 0 && !is_right(right, size, yours);
    plot_view_block_end(plot, right, size);
    if (size > 0) // two empty lines: what follows is the next index
        fprintf(plot->script, "%.*s\n\n", (int)size, right);
    fprintf(plot->script, "%sEOD\n", yours);
    free(yours);
    plot->wrong = plot->wrong || is_wrong;
    return is_wrong;
}

// ---- by name ------------------------------------------------------------------------------------

// NAME = a number or "words": those that a lecturer says instead.
static void define_one(Plot *plot, const char *before, const char *name, const char *value,
                       size_t size)
{
    char *said;
    size_t said_size;
    plot_block_end(plot);
    FILE *out = open_memstream(&said, &said_size);
    const char *quote = value[0] == '"' ? "\"" : "";
    fputs(quote, out);
    own_words_print(out, value + strlen(quote), size - 2 * strlen(quote));
    fputs(quote, out);
    fclose(out);
    fprintf(plot->script, "%s%s = %s\n", before, name, said);
    plot_view_words(plot, text_of("%s%s", before, name).s, said, said_size);
    free(said);
}

// Where something else is right, that goes by the name, and yours by your_NAME.
static void define_both(Plot *plot, const char *name, const char *value, bool is_wrong)
{
    const char *right;
    size_t size = plot_right_value(plot, name, &right);
    define_one(plot, "", name, size > 0 ? right : value, size > 0 ? size : strlen(value));
    if (size > 0 && is_wrong)
        define_one(plot, "your_", name, value, strlen(value));
    plot->wrong = plot->wrong || (size > 0 && is_wrong);
}

// Whether it differs from what is right.
static bool define(Plot *plot, const char *name, const char *value)
{
    const char *right;
    size_t size = plot_right_value(plot, name, &right);
    bool is_wrong = size > 0 && !is_right(right, size, value);
    define_both(plot, name, value, is_wrong);
    return is_wrong;
}

// It is wrong if its numbers are: a 0 that is off by rounding also has another text.
static void define_label(Plot *plot, const char *name, const char *label, bool is_wrong)
{
    char *value = gnuplot_string(label);
    define_both(plot, text_of("%s_text", name).s, value, is_wrong);
    free(value);
}

// ---- numbers and words ------------------------------------------------------------------------

void plot_number_to(Plot *plot, const char *name, double x, int digits)
{
    bool is_wrong = define(plot, name, gnuplot_number(x).s);
    define_label(plot, name, number_shown_to(x, digits).s, is_wrong);
}

void plot_number(Plot *plot, const char *name, double x)
{
    plot_number_to(plot, name, x, SHOWN_DIGITS);
}

void plot_text(Plot *plot, const char *name, const char *text)
{
    char *value = gnuplot_string(text);
    define(plot, name, value);
    free(value);
}

void plot_label(Plot *plot, const char *name, const char *label)
{
    plot_text(plot, text_of("%s_text", name).s, label);
}

// ---- points and vectors -----------------------------------------------------------------------

void plot_point(Plot *plot, const char *name, vec3 point)
{
    plot_block(plot, name, "x y z");
    plot_row_point(plot, point);
    bool is_wrong = plot_block_end(plot);
    define_label(plot, name, vec3_shown(point).s, is_wrong);
    if (is_wrong)
        plot_fit(plot, point, 0);
}

void plot_vector(Plot *plot, const char *name, vec3 from, vec3 vector)
{
    plot_block(plot, name, "x y z of its start, x y z of the vector");
    plot_row_vector(plot, from, vector);
    bool is_wrong = plot_block_end(plot);
    define_label(plot, name, vec3_shown(vector).s, is_wrong);
    if (is_wrong)
        plot_fit(plot, from + vector, 0);
}

void plot_seen_vector(Plot *plot, const char *name, vec3 from, vec3 vector)
{
    plot_vector(plot, name, from, vector);
    plot_fit(plot, from, 0);
    plot_fit(plot, from + vector, 0);
}

void plot_direction(Plot *plot, const char *name, vec3 v)
{
    bool is_wrong = false;
    for (int i = 0; i < 3; i++)
        is_wrong |= define(plot, text_of("%s_%c", name, "xyz"[i]).s, gnuplot_number(v[i]).s);
    define_label(plot, name, vec3_shown(v).s, is_wrong);
}

// ---- pairs of numbers -------------------------------------------------------------------------

void plot_pair_to(Plot *plot, const char *name, const char *first_name, double first,
                  const char *second_name, double second, int digits)
{
    plot_block(plot, name, text_of("%s %s", first_name, second_name).s);
    plot_row(plot, first, second);
    bool is_wrong = plot_block_end(plot);
    define_label(plot, name, pair_shown_to(first, second, digits).s, is_wrong);
    plot_number_to(plot, text_of("%s_%s", name, first_name).s, first, digits);
    plot_number_to(plot, text_of("%s_%s", name, second_name).s, second, digits);
}

void plot_pair(Plot *plot, const char *name, const char *first_name, double first,
               const char *second_name, double second)
{
    plot_pair_to(plot, name, first_name, first, second_name, second, SHOWN_DIGITS);
}
