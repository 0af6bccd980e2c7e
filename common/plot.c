// plot.c - figures: the script is collected in memory, and printed when all of it is there.
#include "common/plot.h"

#include "common/answers.h"
#include "common/text.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#define HEAD "common/plot.gp"

enum { LABEL_DIGITS = 4, DATA_DIGITS = 12 };

struct Plot {
    FILE *script;
    FILE *fit; // rows of $fit
    char *fit_text;
    size_t fit_size;
    FILE *rows; // of the block that is being written
    char *rows_text;
    size_t rows_size;
    const char *block;
    const char *columns;
    char *right; // the script by right answers; NULL where there is none
    bool wrong;  // something differs from it
};

// A label has a minus sign, not a hyphen.
static void print_label(FILE *out, const char *text)
{
    for (; *text != '\0'; text++)
        if (*text == '-')
            fputs("\u2212", out);
        else
            putc(*text, out);
}

static void print_number(FILE *out, double x)
{
    fputs(isfinite(x) ? number_text_to(x, DATA_DIGITS).s : "NaN", out);
}

// ---- what is right ----------------------------------------------------------------------------

// The lines of the right script that define name: from after "NAME<between>" up to end. Returns how
// many characters; 0 where there are none.
static size_t right_of(const Plot *plot, const char *name, const char *between, const char *end,
                       const char **begin)
{
    char key[120];
    snprintf(key, sizeof key, "\n%s%s", name, between);
    const char *found = plot->right != NULL ? strstr(plot->right, key) : NULL;
    if (found == NULL)
        return 0;
    *begin = found + strlen(key);
    const char *stop = strstr(*begin, end);
    return stop != NULL ? (size_t)(stop - *begin) : 0;
}

// The same words, and the same numbers as far as rounding goes?
static bool same_numbers(const char *a, const char *a_end, const char *b, const char *b_end)
{
    while (a < a_end && b < b_end) {
        char *a_next, *b_next;
        double x = strtod(a, &a_next), y = strtod(b, &b_next);
        if ((a_next == a) != (b_next == b))
            return false;
        if (a_next == a) {
            if (*a++ != *b++)
                return false;
            continue;
        }
        if (!(x == y || fabs(x - y) <= 1e-9 * (1 + fabs(x)) || (isnan(x) && isnan(y))))
            return false;
        a = a_next;
        b = b_next;
    }
    return a >= a_end && b >= b_end;
}

// ---- data -------------------------------------------------------------------------------------

static void define(Plot *plot, const char *name, const char *value)
{
    const char *right;
    size_t size = right_of(plot, name, " = ", "\n", &right);
    if (size > 0 && !same_numbers(right, right + size, value, value + strlen(value))) {
        fprintf(plot->script, "%s = %.*s\nyour_", name, (int)size, right);
        plot->wrong = true;
    }
    fprintf(plot->script, "%s = %s\n", name, value);
}

static void define_label(Plot *plot, const char *name, const char *label)
{
    char key[100], *value;
    size_t size;
    FILE *quoted = open_memstream(&value, &size);
    putc('"', quoted);
    print_label(quoted, label);
    putc('"', quoted);
    fclose(quoted);
    snprintf(key, sizeof key, "%s_text", name);
    define(plot, key, value);
    free(value);
}

void plot_number_to(Plot *plot, const char *name, double x, int digits)
{
    define(plot, name, isfinite(x) ? number_text_to(x, DATA_DIGITS).s : "NaN");
    define_label(plot, name, number_text_to(x, digits).s);
}

void plot_number(Plot *plot, const char *name, double x)
{
    plot_number_to(plot, name, x, LABEL_DIGITS);
}

void plot_text(Plot *plot, const char *name, const char *text)
{
    char *value;
    size_t size;
    FILE *quoted = open_memstream(&value, &size);
    putc('"', quoted);
    for (; *text != '\0'; text++) {
        if (*text == '"' || *text == '\\' || *text == '`')
            putc('\\', quoted);
        putc((unsigned char)*text < ' ' ? ' ' : *text, quoted);
    }
    putc('"', quoted);
    fclose(quoted);
    define(plot, name, value);
    free(value);
}

void plot_block(Plot *plot, const char *name, const char *columns)
{
    plot->block = name;
    plot->columns = columns;
    plot->rows = open_memstream(&plot->rows_text, &plot->rows_size);
}

void plot_row(Plot *plot, int count, const double *numbers)
{
    for (int i = 0; i < count; i++) {
        if (i > 0)
            putc(' ', plot->rows);
        print_number(plot->rows, numbers[i]);
    }
    putc('\n', plot->rows);
}

void plot_gap(Plot *plot)
{
    putc('\n', plot->rows);
}

void plot_block_end(Plot *plot)
{
    fclose(plot->rows);
    char name[100];
    const char *right;
    snprintf(name, sizeof name, "$%s", plot->block);
    fprintf(plot->script, "%s << EOD\n# %s\n", name, plot->columns);
    // The right script has its own comment line first.
    size_t size = right_of(plot, name, " << EOD\n", "EOD\n", &right);
    if (size > 0) {
        const char *end = right + size, *rows = strchr(right, '\n') + 1;
        fprintf(plot->script, "%.*s\n\n", (int)(end - rows), rows);
        if (!same_numbers(rows, end, plot->rows_text, plot->rows_text + plot->rows_size))
            plot->wrong = true;
    }
    fprintf(plot->script, "%sEOD\n", plot->rows_text);
    free(plot->rows_text);
}

void plot_fit(Plot *plot, vec3 center, double radius)
{
    const double numbers[] = {center[0], center[1], center[2], radius};
    for (int i = 0; i < 4; i++) {
        print_number(plot->fit, numbers[i]);
        putc(i < 3 ? ' ' : '\n', plot->fit);
    }
}

void plot_point(Plot *plot, const char *name, vec3 point)
{
    plot_block(plot, name, "x y z");
    plot_row(plot, 3, (const double[]){point[0], point[1], point[2]});
    plot_block_end(plot);
    define_label(plot, name, vec3_text_to(point, LABEL_DIGITS).s);
}

void plot_vector(Plot *plot, const char *name, vec3 from, vec3 vector)
{
    plot_block(plot, name, "x y z of its start, x y z of the vector");
    plot_row(plot, 6, (const double[]){from[0], from[1], from[2], vector[0], vector[1], vector[2]});
    plot_block_end(plot);
    define_label(plot, name, vec3_text_to(vector, LABEL_DIGITS).s);
}

void plot_direction(Plot *plot, const char *name, vec3 v)
{
    static const char axes[] = "xyz";
    for (int i = 0; i < 3; i++) {
        char key[100];
        snprintf(key, sizeof key, "%s_%c", name, axes[i]);
        define(plot, key, number_text_to(v[i], DATA_DIGITS).s);
    }
    define_label(plot, name, vec3_text_to(v, LABEL_DIGITS).s);
}

// ---- the script -------------------------------------------------------------------------------

// All of a file, for freeing; NULL and a message where it cannot be read.
static char *text_of_file(const char *program, const char *path)
{
    char *text = NULL;
    size_t size;
    FILE *file = fopen(path, "r"), *copy = open_memstream(&text, &size);
    if (file == NULL || copy == NULL) {
        fprintf(stderr, "%s: cannot read %s: figures are drawn from the top of the project\n",
                program, path);
        if (copy != NULL)
            fclose(copy);
        free(text);
        return NULL;
    }
    char part[4096];
    for (size_t n; (n = fread(part, 1, sizeof part, file)) > 0;)
        fwrite(part, 1, n, copy);
    fclose(file);
    fclose(copy);
    return text;
}

static const Figure *figure_named(const char *program, const Figure *figures, const char *name)
{
    for (const Figure *figure = figures; figure->name != NULL; figure++)
        if (strcmp(figure->name, name) == 0)
            return figure;
    fprintf(stderr, "%s: --figure %s: expected", program, word_text(name).s);
    for (const Figure *figure = figures; figure->name != NULL; figure++)
        fprintf(stderr, "%s %s", figure == figures ? "" : " or", figure->name);
    fprintf(stderr, "\n");
    exit(EXIT_WRONG_USAGE);
}

static void write_script(Plot *plot, const Figure *figure, const char *head, const char *layout,
                         void *given)
{
    fprintf(plot->script, "name = \"%s\"\n%s\n# ---- the data\n\n", figure->name, head);
    figure->data(plot, given);
    fclose(plot->fit);
    fprintf(plot->script, "$fit << EOD\n# x y z radius of what has to be seen\n%sEOD\n",
            plot->fit_text);
    fprintf(plot->script, "wrong = %d\n@legend\n\n# ---- the layout\n\n%s\n@finish\n", plot->wrong,
            layout);
}

int plot_figure(const char *program, const char *chapter, const Figure *figures,
                FigureCommand command, void *given)
{
    const Figure *figure = figure_named(program, figures, command.name);
    char path[300], *script = NULL;
    size_t size;
    snprintf(path, sizeof path, "%s/%s.gp", chapter, figure->name);
    char *head = text_of_file(program, HEAD);
    char *layout = head != NULL ? text_of_file(program, path) : NULL;
    Plot plot = {.script = open_memstream(&script, &size)};
    plot.fit = open_memstream(&plot.fit_text, &plot.fit_size);
    if (command.right != NULL && layout != NULL)
        plot.right = text_of_file(program, command.right);
    int status = EXIT_COULD_NOT;
    if (layout != NULL && (command.right == NULL || plot.right != NULL)) {
        write_script(&plot, figure, head, layout, given);
        fflush(plot.script);
        status = answers_report();
        if (status == EXIT_DONE && (fputs(script, stdout) == EOF || fflush(stdout) != 0)) {
            fprintf(stderr, "%s: the script could not be printed\n", program);
            status = EXIT_COULD_NOT;
        }
    } else {
        fclose(plot.fit);
    }
    fclose(plot.script);
    free(plot.fit_text);
    free(plot.right);
    free(layout);
    free(head);
    free(script);
    return status;
}
