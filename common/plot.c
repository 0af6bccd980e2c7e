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
    FILE *included; // what stands before the data
    FILE *fit;      // rows of $fit
    char *fit_text;
    size_t fit_size;
    FILE *rows; // of the block that is being written
    char *rows_text;
    size_t rows_size;
    const char *block;
    const char *columns;
    char *right; // the data by right answers; NULL where there are none
    bool wrong;  // something differs from them
    bool failed; // a file could not be read; that has been said
};

// A string of gnuplot's, and nothing else: no command can begin in it. A label of numbers has a
// minus sign, not a hyphen.
static void print_quoted(FILE *out, const char *text, bool is_label)
{
    putc('"', out);
    for (; *text != '\0'; text++) {
        if (*text == '"' || *text == '\\')
            putc('\\', out);
        if (*text == '-' && is_label)
            fputs("\u2212", out);
        else // a backquote would run what is between two of them
            putc((unsigned char)*text < ' ' ? ' ' : *text == '`' ? '\'' : *text, out);
    }
    putc('"', out);
}

static void print_number(FILE *out, double x)
{
    fputs(isfinite(x) ? number_text_to(x, DATA_DIGITS).s : "NaN", out);
}

// ---- what is right ----------------------------------------------------------------------------

// The lines of the right data that define name: from after "NAME<between>" up to end. Returns how
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

// A number as data or a label has it; next is behind it, or at its begin where there is none.
static double number_at(const char *text, const char **next)
{
    bool minus = strncmp(text, "\u2212", strlen("\u2212")) == 0;
    const char *digits = text + (minus ? strlen("\u2212") : 0);
    char *end;
    double x = strtod(digits, &end);
    *next = end == digits ? text : end;
    if (end != digits && end[0] == 'e') // 1e−7
        x *= pow(10, number_at(end + 1, next));
    return minus ? -x : x;
}

// The same words, and the same numbers as far as rounding goes?
static bool same_numbers(const char *a, const char *a_end, const char *b, const char *b_end)
{
    while (a < a_end && b < b_end) {
        const char *a_next, *b_next;
        double x = number_at(a, &a_next), y = number_at(b, &b_next);
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

// Where something else is right, that goes by the name, and yours by your_NAME.
static void define_both(Plot *plot, const char *name, const char *value, bool is_wrong)
{
    const char *right;
    size_t size = right_of(plot, name, " = ", "\n", &right);
    if (size > 0)
        fprintf(plot->script, "%s = %.*s\n", name, (int)size, right);
    if (size == 0 || is_wrong)
        fprintf(plot->script, "%s%s = %s\n", size > 0 ? "your_" : "", name, value);
    plot->wrong = plot->wrong || (size > 0 && is_wrong);
}

// Whether it differs from what is right.
static bool define(Plot *plot, const char *name, const char *value)
{
    const char *right;
    size_t size = right_of(plot, name, " = ", "\n", &right);
    bool is_wrong = size > 0 && !same_numbers(right, right + size, value, value + strlen(value));
    define_both(plot, name, value, is_wrong);
    return is_wrong;
}

// It is wrong where the numbers are that it shows: what rounding leaves of 0 reads otherwise, too.
static void define_label(Plot *plot, const char *name, const char *label, bool is_wrong)
{
    char key[100], *value;
    size_t size;
    FILE *quoted = open_memstream(&value, &size);
    print_quoted(quoted, label, true);
    fclose(quoted);
    snprintf(key, sizeof key, "%s_text", name);
    define_both(plot, key, value, is_wrong);
    free(value);
}

void plot_number_to(Plot *plot, const char *name, double x, int digits)
{
    bool is_wrong = define(plot, name, isfinite(x) ? number_text_to(x, DATA_DIGITS).s : "NaN");
    define_label(plot, name, number_text_to(x, digits).s, is_wrong);
}

void plot_number(Plot *plot, const char *name, double x)
{
    plot_number_to(plot, name, x, LABEL_DIGITS);
}

static void define_text(Plot *plot, const char *name, const char *text, bool is_label)
{
    char *value;
    size_t size;
    FILE *quoted = open_memstream(&value, &size);
    print_quoted(quoted, text, is_label);
    fclose(quoted);
    define(plot, name, value);
    free(value);
}

void plot_text(Plot *plot, const char *name, const char *text)
{
    define_text(plot, name, text, false);
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

// ---- what has to be seen ----------------------------------------------------------------------

// What is right has to be seen whatever is wrong, in rows of $fit.
static size_t right_fit(const Plot *plot, const char **rows)
{
    size_t size = right_of(plot, "$fit", " << EOD\n", "EOD\n", rows);
    const char *line = size > 0 ? strchr(*rows, '\n') : NULL; // the comment
    if (line == NULL)
        return 0;
    size -= (size_t)(line + 1 - *rows);
    *rows = line + 1;
    return size;
}

void plot_fit(Plot *plot, vec3 center, double radius)
{
    if (!vec3_is_finite(center) || !isfinite(radius))
        return;
    const double numbers[] = {center[0], center[1], center[2], radius};
    for (int i = 0; i < 4; i++) {
        print_number(plot->fit, numbers[i]);
        putc(i < 3 ? ' ' : '\n', plot->fit);
    }
}

// What is wrong, where that is near enough to leave the rest of the figure legible.
static void fit_what_is_wrong(Plot *plot, vec3 place)
{
    enum { TIMES = 3 };
    const char *row;
    double x, y, z, radius, far = 0, away = INFINITY;
    vec3 first = place;
    int used, count = 0;
    for (size_t left = right_fit(plot, &row); left > 0; left -= (size_t)used, row += used) {
        if (sscanf(row, "%lf %lf %lf %lf\n%n", &x, &y, &z, &radius, &used) != 4)
            return;
        vec3 seen = vec3_of(x, y, z);
        first = count++ == 0 ? seen : first;
        far = fmax(far, vec3_length(seen - first) + radius);
        away = fmin(away, vec3_length(place - seen));
    }
    if (away <= TIMES * far)
        plot_fit(plot, place, 0);
}

// Of a block that has no row, or none without a NaN, as many far off the canvas, at least one:
// gnuplot 5.4 warns of the one, and crashes on labels of the other.
static char *nowhere(const char *rows)
{
    char *text;
    size_t size;
    FILE *instead = open_memstream(&text, &size);
    do {
        fputs("1e9 1e9 1e9 1e9 1e9 1e9 1e9 1e9 1e9 1e9 1e9 1e9\n", instead);
        rows = strchr(rows, '\n');
    } while (rows != NULL && *++rows != '\0');
    fclose(instead);
    return text;
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

static bool end_block(Plot *plot)
{
    fclose(plot->rows);
    char name[100];
    if (!has_rows(plot->rows_text)) {
        char *instead = nowhere(plot->rows_text);
        free(plot->rows_text);
        plot->rows_text = instead;
    }
    const char *right, *yours = plot->rows_text;
    bool is_wrong = false;
    snprintf(name, sizeof name, "$%s", plot->block);
    fprintf(plot->script, "%s << EOD\n# %s\n", name, plot->columns);
    // The right data have their own comment line first.
    size_t size = right_of(plot, name, " << EOD\n", "EOD\n", &right);
    if (size > 0) {
        const char *end = right + size, *rows = strchr(right, '\n') + 1;
        is_wrong = !same_numbers(rows, end, yours, yours + strlen(yours));
        fprintf(plot->script, "%.*s\n\n", (int)(end - rows), rows);
    }
    fprintf(plot->script, "%sEOD\n", yours);
    free(plot->rows_text);
    plot->wrong = plot->wrong || is_wrong;
    return is_wrong;
}

void plot_block_end(Plot *plot)
{
    end_block(plot);
}

void plot_point(Plot *plot, const char *name, vec3 point)
{
    plot_block(plot, name, "x y z");
    plot_row(plot, 3, (const double[]){point[0], point[1], point[2]});
    bool is_wrong = end_block(plot);
    define_label(plot, name, vec3_text_to(point, LABEL_DIGITS).s, is_wrong);
    if (is_wrong)
        fit_what_is_wrong(plot, point);
}

void plot_vector(Plot *plot, const char *name, vec3 from, vec3 vector)
{
    plot_block(plot, name, "x y z of its start, x y z of the vector");
    plot_row(plot, 6, (const double[]){from[0], from[1], from[2], vector[0], vector[1], vector[2]});
    bool is_wrong = end_block(plot);
    define_label(plot, name, vec3_text_to(vector, LABEL_DIGITS).s, is_wrong);
    if (is_wrong)
        fit_what_is_wrong(plot, from + vector);
}

void plot_direction(Plot *plot, const char *name, vec3 v)
{
    static const char axes[] = "xyz";
    bool is_wrong = false;
    for (int i = 0; i < 3; i++) {
        char key[100];
        snprintf(key, sizeof key, "%s_%c", name, axes[i]);
        bool differs =
            define(plot, key, isfinite(v[i]) ? number_text_to(v[i], DATA_DIGITS).s : "NaN");
        is_wrong = is_wrong || differs;
    }
    define_label(plot, name, vec3_text_to(v, LABEL_DIGITS).s, is_wrong);
}

void plot_label(Plot *plot, const char *name, const char *label)
{
    char key[100];
    snprintf(key, sizeof key, "%s_text", name);
    define_text(plot, key, label, true);
}

// ---- flat: pairs of numbers -------------------------------------------------------------------

static void define_part(Plot *plot, const char *name, const char *part, double x)
{
    char key[100];
    snprintf(key, sizeof key, "%s_%s", name, part);
    bool is_wrong = define(plot, key, isfinite(x) ? number_text_to(x, DATA_DIGITS).s : "NaN");
    define_label(plot, key, number_text(x).s, is_wrong);
}

void plot_pair(Plot *plot, const char *name, const char *first_name, double first,
               const char *second_name, double second)
{
    char columns[100];
    snprintf(columns, sizeof columns, "%s %s", first_name, second_name);
    plot_block(plot, name, columns);
    plot_row(plot, 2, (const double[]){first, second});
    bool is_wrong = end_block(plot);
    define_label(plot, name, pair_text(first, second).s, is_wrong);
    define_part(plot, name, first_name, first);
    define_part(plot, name, second_name, second);
}

// ---- the script -------------------------------------------------------------------------------

// All of a file, for freeing; NULL and a message where it cannot be read.
static char *text_of_file(const char *path)
{
    char *text = NULL;
    size_t size;
    FILE *file = fopen(path, "r"), *copy = open_memstream(&text, &size);
    if (file == NULL || copy == NULL) {
        fprintf(stderr, "cannot read %s: figures are drawn from the top of the project\n", path);
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

void plot_include(Plot *plot, const char *path)
{
    char *text = text_of_file(path);
    if (text == NULL)
        plot->failed = true;
    else
        fprintf(plot->included, "%s\n", text);
    free(text);
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

#define DATA_BEGIN "\n# ---- the data\n"
#define DATA_END "\n# ---- the layout\n"

// Of a script by right answers, the data: what stands between the two. All of it where it is only
// those.
static void keep_data(char *script)
{
    char *begin = strstr(script, DATA_BEGIN);
    if (begin != NULL)
        memmove(script, begin, strlen(begin) + 1);
    char *end = strstr(script, DATA_END);
    if (end != NULL)
        *end = '\0';
}

// Whether something is wrong has to be known at the top, and is only behind the data.
static void write_script(Plot *plot, FILE *out, const Figure *figure, const char *head,
                         const char *layout, const char *note, void *given)
{
    char *data, *included;
    size_t size, included_size;
    plot->script = open_memstream(&data, &size);
    plot->included = open_memstream(&included, &included_size);
    plot->fit = open_memstream(&plot->fit_text, &plot->fit_size);
    figure->data(plot, given);
    fclose(plot->included);
    fclose(plot->fit);
    const char *rows = "";
    int right = (int)right_fit(plot, &rows);
    fprintf(plot->script, "$fit << EOD\n# x y z radius of what has to be seen\n%.*s%sEOD\n", right,
            rows, plot->fit_text);
    fclose(plot->script);
    fprintf(out, "name = \"%s\"\nwrong = %d\n", figure->name, plot->wrong);
    if (note != NULL && plot->wrong) {
        fprintf(out, "note = ");
        print_quoted(out, note, false);
        fprintf(out, "\n");
    }
    fprintf(out, "%s\n%s" DATA_BEGIN "\n%s" DATA_END "\n@legend\n%s\n@finish\n", head, included,
            data, layout);
    free(plot->fit_text);
    free(included);
    free(data);
}

bool plot_script(FILE *out, const char *layout, const Figure *figure, const char *right,
                 const char *note, void *given)
{
    char *head_text = text_of_file(HEAD);
    char *layout_text = head_text != NULL ? text_of_file(layout) : NULL;
    Plot plot = {.right = right != NULL && layout_text != NULL ? text_of_file(right) : NULL};
    bool read = layout_text != NULL && (right == NULL || plot.right != NULL);
    if (plot.right != NULL)
        keep_data(plot.right);
    if (read)
        write_script(&plot, out, figure, head_text, layout_text, note, given);
    read = read && !plot.failed;
    free(plot.right);
    free(layout_text);
    free(head_text);
    return read;
}

int plot_figure(const char *program, const char *chapter, const Figure *figures,
                FigureCommand command, void *given)
{
    const Figure *figure = figure_named(program, figures, command.name);
    char path[300], *script = NULL;
    size_t size;
    snprintf(path, sizeof path, "%s/%s.gp", chapter, figure->name);
    FILE *out = open_memstream(&script, &size);
    bool written = plot_script(out, path, figure, command.right, command.note, given);
    fclose(out);
    int status = written ? answers_report() : EXIT_COULD_NOT;
    if (status == EXIT_DONE && (fputs(script, stdout) == EOF || fflush(stdout) != 0)) {
        fprintf(stderr, "%s: the script could not be printed\n", program);
        status = EXIT_COULD_NOT;
    }
    free(script);
    return status;
}
