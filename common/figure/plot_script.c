// plot_script.c - figures: head, data and layout become one script, in memory, and it is printed
// when all of it is there.
#include "common/answers.h"
#include "common/figure/plot_internal.h"
#include "common/text.h"
#include "common/toolkit_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#define HEAD "common/figure/plot.gp"
#define DATA_BEGIN "\n# ---- the data\n"
#define DATA_END "\n# ---- the view\n"
#define LAYOUT "\n# ---- the layout\n"

// The program that prints a figure; NULL: another one, in its own tree.
static const char *printing;

// All of a file, for freeing; NULL and a message where it cannot be read.
static char *text_of_file(const char *path)
{
    char *text = NULL, part[4096];
    size_t size;
    FILE *file = fopen(path, "r"), *copy = file != NULL ? open_memstream(&text, &size) : NULL;
    for (size_t n; copy != NULL && (n = fread(part, 1, sizeof part, file)) > 0;)
        fwrite(part, 1, n, copy);
    bool read = copy != NULL && !ferror(file); // not a folder, for example
    if (!read)
        fprintf(stderr, "%s: cannot be read: %s\n", path, strerror(errno));
    if (copy != NULL)
        fclose(copy);
    if (file != NULL)
        fclose(file);
    if (read)
        return text;
    free(text);
    return NULL;
}

// The same of a file of the toolkit, whatever the current folder is.
static char *text_of_toolkit_file(const char *name)
{
    char path[4096];
    return toolkit_file(path, sizeof path, printing, name) ? text_of_file(path) : NULL;
}

void plot_include(Plot *plot, const char *path)
{
    char *text = text_of_toolkit_file(path);
    if (text == NULL)
        plot->failed = true;
    else
        fprintf(plot->included, "%s\n", text);
    free(text);
}

// The data of a script by right answers: the text between the two lines, or all of it if it is
// only data.
static void keep_data(char *script)
{
    char *begin = strstr(script, DATA_BEGIN);
    if (begin != NULL)
        memmove(script, begin, strlen(begin) + 1);
    char *end = strstr(script, DATA_END);
    if (end != NULL)
        *end = '\0';
}

void plot_below(Plot *plot, const char *color, const char *words)
{
    char *own = own_words(words), *text = gnuplot_string(own);
    int i = ++plot->paragraphs;
    fprintf(plot->strip, "strip_text[%d] = %s\nstrip_color[%d] = \"%s\"\n", i, text, i, color);
    free(text);
    free(own);
}

// The top of the script must say whether something is wrong, but that is known only after the data.
static void write_script(Plot *plot, FILE *out, const Figure *figure, const char *head,
                         const char *file, const char *layout, const char *note, void *given)
{
    char *data, *included, *strip;
    size_t size, included_size, strip_size;
    plot->strip = open_memstream(&strip, &strip_size);
    plot->script = open_memstream(&data, &size);
    plot->included = open_memstream(&included, &included_size);
    figure->data(plot, given);
    plot_view_fits_end(plot);
    fputs(DATA_END "\n", plot->script);
    bool placed = plot_view_end(plot);
    if (note != NULL && note[0] != '\0' && plot->wrong)
        plot_below(plot, "ink", note);
    fclose(plot->strip);
    fclose(plot->included);
    fclose(plot->script);
    char *name = gnuplot_string(figure->name), *from = gnuplot_string(file);
    fprintf(out, "name = %s\nlayout_file = %s\nwrong = %d\n", name, from, plot->wrong);
    free(name);
    free(from);
    if (placed)
        fprintf(out, "text_size = %d\n", TEXT_SIZE);
    if (plot_is_dragged(plot))
        fputs("dragged = 1\n", out);
    if (note != NULL && plot->wrong) {
        char *said = gnuplot_string(note);
        fprintf(out, "note = %s\n", said);
        free(said);
    }
    fprintf(out, "strip_count = %d\narray strip_text[%d]\narray strip_color[%d]\n%s",
            plot->paragraphs, plot->paragraphs + 1, plot->paragraphs + 1, strip);
    free(strip);
    own_words_define(out);
    fprintf(out, "%s\n%s" DATA_BEGIN "\n%s\n@legend\n" LAYOUT "\n%s\n@finish\n", head, included,
            data, layout);
    free(included);
    free(data);
}

// A file in the folder of a page; NULL, and a message on stderr, if it cannot be written.
static FILE *live_file(const char *folder, const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    if (file == NULL)
        fprintf(stderr, "%s: cannot be written: %s\n", path, strerror(errno));
    return file;
}

// What the command says for a page. False, and a message on stderr, if it is wrong.
static bool prepare_page(Plot *plot, const FigureCommand *command)
{
    bool narrow = command->shape != NULL && strcmp(command->shape, "4:3") == 0;
    if (command->shape != NULL && !narrow && strcmp(command->shape, "16:9") != 0) {
        fprintf(stderr, "--shape %s: expected 16:9 or 4:3\n", word_text(command->shape).s);
        return false;
    }
    if (command->shape != NULL)
        plot_view_only(plot, narrow);
    if (command->held != NULL && !plot_view_hold(plot, command->held)) {
        fprintf(stderr, "--held %s: expected the view of a figure\n", word_text(command->held).s);
        return false;
    }
    plot->is_moved = command->drag != NULL;
    plot->is_live = command->live != NULL || plot->is_moved;
    if (command->live != NULL) {
        plot->pictures = live_file(command->live, "pictures");
        return plot->pictures != NULL && fputs("\n", plot->pictures) != EOF;
    }
    return true;
}

static bool finish_page(Plot *plot, FILE *out, const FigureCommand *command)
{
    bool done = true;
    if (command->drag != NULL)
        done = plot_handles_drag(plot, command->drag, out);
    if (command->live != NULL) {
        FILE *file = live_file(command->live, "handles.json");
        if (file != NULL)
            plot_handles_print(plot, file);
        done = file != NULL && fclose(file) == 0 && done;
    }
    if (plot->pictures != NULL)
        done = fclose(plot->pictures) == 0 && done;
    return done;
}

// By the layout of the command, which is somebody's own, or by a file of the toolkit.
static bool write_figure(FILE *out, const char *layout, const Figure *figure,
                         const FigureCommand *command, void *given)
{
    char *head_text = text_of_toolkit_file(HEAD), *layout_text = NULL, *unused = NULL;
    if (head_text != NULL)
        layout_text =
            command->layout != NULL ? text_of_file(command->layout) : text_of_toolkit_file(layout);
    Plot plot = {.view = plot_view_new()};
    if (command->right != NULL && layout_text != NULL)
        plot.right = text_of_file(command->right);
    bool done = layout_text != NULL && (command->right == NULL || plot.right != NULL) &&
                prepare_page(&plot, command);
    if (plot.right != NULL)
        keep_data(plot.right);
    size_t size;
    FILE *script = command->drag != NULL ? open_memstream(&unused, &size) : out;
    if (done) {
        write_script(&plot, script, figure, head_text,
                     command->layout != NULL ? command->layout : layout, layout_text, command->note,
                     given);
        done = finish_page(&plot, out, command) && !plot.failed;
    }
    if (script != out)
        fclose(script);
    plot_view_free(plot.view);
    free(unused);
    free(plot.right);
    free(layout_text);
    free(head_text);
    return done;
}

bool plot_script(FILE *out, const char *layout, const Figure *figure, const char *right,
                 const char *note, void *given)
{
    return write_figure(out, layout, figure, &(FigureCommand){.right = right, .note = note}, given);
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

int plot_figure(const char *program, const char *chapter, const Figure *figures,
                FigureCommand command, void *given)
{
    if (strcmp(command.name, "list") == 0) {
        for (; figures->name != NULL; figures++)
            puts(figures->name);
        return EXIT_DONE;
    }
    Figure figure = *figure_named(program, figures, command.name);
    Text layout = text_of("%s/figures/%s.gp", chapter, figure.name), name;
    if (command.layout != NULL) { // a figure of somebody's own has the name of its file
        const char *slash = strrchr(command.layout, '/');
        name = text_of("%s", slash != NULL ? slash + 1 : command.layout);
        char *dot = strrchr(name.s, '.');
        if (dot != NULL && dot > name.s)
            *dot = '\0';
        figure.name = name.s;
    }
    char *script = NULL;
    size_t size;
    printing = program;
    FILE *out = open_memstream(&script, &size);
    bool written = write_figure(out, layout.s, &figure, &command, given);
    fclose(out);
    for (int i = 0; command.answers && i < answers_called(); i++)
        puts(answer_that_was_called(i));
    int status = command.answers ? EXIT_DONE : written ? answers_report() : EXIT_COULD_NOT;
    if (!command.answers && status == EXIT_DONE)
        fputs(script, stdout);
    free(script);
    return status;
}
