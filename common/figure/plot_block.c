// plot_block.c - figures: tables, which gnuplot calls data blocks, row by row.
#include "common/figure/gnuplot.h"
#include "common/figure/plot_internal.h"

#include <stdlib.h>
#include <string.h>

void plot_block(Plot *plot, const char *name, const char *columns)
{
    plot->block = name;
    plot->columns = columns;
    plot->rows = open_memstream(&plot->rows_text, &plot->rows_size);
    plot_view_block(plot, name, columns);
}

void plot_row(Plot *plot, int count, const double *numbers)
{
    for (int i = 0; i < count; i++)
        fprintf(plot->rows, "%s%s", i > 0 ? " " : "", gnuplot_number(numbers[i]).s);
    putc('\n', plot->rows);
}

void plot_row_point(Plot *plot, vec3 point)
{
    plot_view_row(plot, point, vec3_of(0, 0, 0));
    plot_row(plot, 3, (const double[]){point[0], point[1], point[2]});
}

void plot_row_vector(Plot *plot, vec3 from, vec3 vector)
{
    plot_view_row(plot, from, vector);
    plot_row(plot, 6, (const double[]){from[0], from[1], from[2], vector[0], vector[1], vector[2]});
}

void plot_row_dot(Plot *plot, int count, const double *numbers)
{
    plot_view_gap(plot);
    plot_view_row(plot, vec3_of(numbers[0], numbers[1], numbers[2]), vec3_of(0, 0, 0));
    plot_row(plot, count, numbers);
}

void plot_row_vector_with(Plot *plot, vec3 from, vec3 vector, double number)
{
    plot_view_row(plot, from, vector);
    plot_row(plot, 7,
             (const double[]){from[0], from[1], from[2], vector[0], vector[1], vector[2], number});
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
    fclose(plot->rows);
    char *yours = drawable(plot->rows_text);
    fprintf(plot->script, "$%s << EOD\n# %s\n", plot->block, plot->columns);
    const char *right;
    size_t size = plot_right_rows(plot, plot->block, &right);
    bool is_wrong = size > 0 && !plot_is_right(right, size, yours);
    plot_view_block_end(plot, right, size);
    if (size > 0) // two empty lines: what follows is the next index
        fprintf(plot->script, "%.*s\n\n", (int)size, right);
    fprintf(plot->script, "%sEOD\n", yours);
    free(yours);
    plot->wrong = plot->wrong || is_wrong;
    return is_wrong;
}
