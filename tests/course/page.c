// page.c - text for a reader: as wide as the terminal, and in color if the terminal has colors.
#include "tests/course/page.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum { USUAL_COLUMNS = 80, FEWEST_COLUMNS = 40, MOST_COLUMNS = 1000, MOST_PRINTED_LINES = 8 };

static int columns_of(FILE *out)
{
    const char *wanted = getenv("COLUMNS");
    long columns = wanted != NULL ? strtol(wanted, NULL, 10) : 0;
    struct winsize size;
    if (columns <= 0 && ioctl(fileno(out), TIOCGWINSZ, &size) == 0)
        columns = size.ws_col;
    if (columns <= 0)
        columns = USUAL_COLUMNS;
    return columns < FEWEST_COLUMNS ? FEWEST_COLUMNS
           : columns > MOST_COLUMNS ? MOST_COLUMNS
                                    : (int)columns;
}

Page page_on(FILE *out)
{
    const char *no_color = getenv("NO_COLOR"), *term = getenv("TERM");
    return (Page){out, columns_of(out) - 1,
                  isatty(fileno(out)) == 1 && (no_color == NULL || no_color[0] == '\0') &&
                      term != NULL && strcmp(term, "dumb") != 0,
                  false, getenv("WEB") != NULL};
}

static void begin(const Page *page, PageColor color)
{
    if (page->colors && color != PLAIN)
        fprintf(page->out, "\033[%dm", color);
}

static void end(const Page *page, PageColor color)
{
    if (page->colors && color != PLAIN)
        fprintf(page->out, "\033[0m");
}

void page_terminal(const Page *page, const char *format, ...)
{
    va_list given;
    va_start(given, format);
    if (!page->is_web)
        vfprintf(page->out, format, given);
    va_end(given);
}

void page_part(const Page *page, const char *kind, const char *label, const char *words)
{
    if (page->is_web)
        fprintf(page->out, "%s\x1f%s\x1f%s\x1e", kind, label, words);
}

void page_line(const Page *page, PageColor color, const char *format, ...)
{
    va_list given;
    va_start(given, format);
    if (!page->is_web) {
        begin(page, color);
        vfprintf(page->out, format, given);
        end(page, color);
        putc('\n', page->out);
    }
    va_end(given);
}

// Up to the next blank outside parentheses: a vector stays in one piece.
static int length_of_word(const char *words, int room)
{
    int length = 0, depth = 0;
    for (; words[length] != '\0' && (words[length] != ' ' || depth > 0); length++)
        depth += (words[length] == '(') - (words[length] == ')');
    return length < room ? length : (int)strcspn(words, " ");
}

// From a column on; the color ends with each line, so that no margin has it.
static void wrap(const Page *page, PageColor color, int column, int margin, const char *words)
{
    int room = page->columns - margin;
    bool is_first = true; // word of its line
    begin(page, words[0] != '\0' ? color : PLAIN);
    for (const char *word = words; *word != '\0'; word += strspn(word, " ")) {
        int length = length_of_word(word, room);
        if (!is_first && column + 1 + length > page->columns) {
            end(page, color);
            fprintf(page->out, "\n%*s", margin, "");
            begin(page, color);
            column = margin;
        } else if (!is_first) {
            putc(' ', page->out);
            column++;
        }
        for (int i = 0; i < length; i++)
            putc(word[i] == '~' ? ' ' : word[i], page->out);
        column += length;
        word += length;
        is_first = false;
    }
    end(page, words[0] != '\0' ? color : PLAIN);
    putc('\n', page->out);
}

void page_field(const Page *page, PageColor color, const char *label, const char *words)
{
    page_part(page, "field", label, words);
    if (page->is_web)
        return;
    int column = fprintf(page->out, "  %-*s", PAGE_LABEL - 2, label);
    if (column > PAGE_LABEL) // a long label
        column += fprintf(page->out, " ");
    wrap(page, color, column, PAGE_LABEL, words);
}

void page_words(const Page *page, PageColor color, int first, int others, const char *format, ...)
{
    char words[8200];
    va_list given;
    va_start(given, format);
    vsnprintf(words, sizeof words, format, given);
    va_end(given);
    page_part(page, "words", "", words);
    if (page->is_web)
        return;
    fprintf(page->out, "%*s", first, "");
    wrap(page, color, first, others, words);
}

void page_printed(const Page *page, const char *label, const char *text)
{
    int column = 0, lines = 0;
    if (text[0] != '\0')
        page_part(page, "printed", label, text);
    if (page->is_web)
        return;
    for (; *text != '\0' && lines < MOST_PRINTED_LINES; text++) {
        if (column == 0 && lines == 0)
            fprintf(page->out, "  %-*s", PAGE_LABEL - 2, label);
        else if (column == 0)
            fprintf(page->out, "%*s", PAGE_LABEL, "");
        if (*text == '\n' || column == page->columns - PAGE_LABEL) {
            putc('\n', page->out);
            column = 0;
            lines++;
        }
        if (*text != '\n') {
            putc((*text >= ' ' && *text < 127) ? *text : '?', page->out);
            column++;
        }
    }
    if (column > 0)
        putc('\n', page->out);
    if (*text != '\0')
        fprintf(page->out, "%*s... and more\n", PAGE_LABEL, "");
}

// ---- one call of a test ------------------------------------------------------------------------

static void show_given(const Page *page, const char *given)
{
    while (*given != '\0') {
        char label[64], value[1300];
        int used = 0;
        if (sscanf(given, "%63[^\t]\t%1299[^\n]\n%n", label, value, &used) != 2)
            return;
        page_field(page, PLAIN, label, value);
        given += used;
    }
}

void show_call(const Page *page, const ShownCall *call)
{
    const char *yours = call->missing[0] != '\0' ? "not answered yet" : call->yours;
    if (call->hidden) {
        page_field(page, PLAIN, "given", "random numbers of this run, not shown");
        if (call->missing[0] != '\0')
            page_field(page, RED, "yours", yours);
        else if (call->expected[0] == '\0' && call->how[0] != '\0')
            page_field(page, RED, "it", call->how);
        return;
    }
    show_given(page, call->given);
    if (call->expected[0] != '\0') {
        page_field(page, GREEN, "expected", call->expected);
        page_field(page, RED, "yours", yours);
    } else {
        page_field(page, RED, "it", call->how);
    }
    page_printed(page, "it printed", call->printed);
}
