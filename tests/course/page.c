// page.c - text for a reader: as wide as the terminal, and in colour if the terminal has colours.
#include "tests/course/page.h"

#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum {
    USUAL_COLUMNS = 80,
    FEWEST_COLUMNS = 40,
    MOST_COLUMNS = 1000,
    MOST_ROWS = 1000,
    MOST_PRINTED_LINES = 8
};

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
                  0};
}

int page_rows(FILE *out)
{
    struct winsize size;
    if (isatty(fileno(out)) != 1)
        return 0;
    return ioctl(fileno(out), TIOCGWINSZ, &size) == 0 && size.ws_row > 0 ? size.ws_row : MOST_ROWS;
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

void page_line(const Page *page, PageColor color, const char *line)
{
    begin(page, line[0] != '\0' ? color : PLAIN);
    fprintf(page->out, "%s", line);
    end(page, line[0] != '\0' ? color : PLAIN);
    putc('\n', page->out);
}

// Up to the next blank outside parentheses: a vector stays in one piece.
static int length_of_word(const char *words, int room)
{
    int length = 0, depth = 0;
    for (; words[length] != '\0' && (words[length] != ' ' || depth > 0); length++)
        depth += (words[length] == '(') - (words[length] == ')');
    return length < room ? length : (int)strcspn(words, " ");
}

// From a column on; the colour ends with each line, so that no margin has it.
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
    int column = fprintf(page->out, "  %-*s", PAGE_LABEL - 2, label);
    if (column > PAGE_LABEL) // a long label
        column += fprintf(page->out, " ");
    wrap(page, color, column, PAGE_LABEL, words);
}

void page_words(const Page *page, PageColor color, int first, int others, const char *words)
{
    fprintf(page->out, "%*s", first, "");
    wrap(page, color, first, others, words);
}

void page_printed(const Page *page, const char *label, const char *text)
{
    int column = 0, lines = 0;
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

// ---- as high as the terminal -------------------------------------------------------------------

typedef struct {
    const char *text; // NULL: cut
    int rows;
} PageLine;

static int rows_of(const Page *page, const char *line)
{
    int letters = 0, columns = page->columns + 1;
    for (; *line != '\0'; line++)
        if (*line == '\033')
            line += strcspn(line, "m");
        else
            letters += ((unsigned char)*line & 0xC0) != 0x80;
    return letters == 0 ? 1 : (letters + columns - 1) / columns;
}

// Cuts the last of the lines from one to another; the last has the words instead. How many rows are
// still too many.
static int cut(PageLine *lines, int from, int to, int too_many, const char *words)
{
    int saved = -1;
    if (to - from < 2) // the words need a row as well
        return too_many;
    for (; too_many > 0 && to > from && saved < too_many; saved += lines[to].rows)
        lines[--to].text = NULL;
    if (saved >= 0)
        lines[to] = (PageLine){words, 1};
    return saved > 0 ? too_many - saved : too_many;
}

static bool begins_any(const char *line, const char *const *words)
{
    while (*words != NULL && strncmp(line, *words, strlen(*words)) != 0)
        words++;
    return *words != NULL;
}

int page_fit(const Page *page, char *text, int rows, const char *command)
{
    enum { MOST_LINES = 400 };
    PageLine lines[MOST_LINES];
    char words[200];
    int count = 0, end = 0, result = 0, tried = 0, all = 0;
    for (char *line; text != NULL && *text != '\0' && count < MOST_LINES;) {
        if (*text == PAGE_END_OF_VERDICT) {
            end = count;
            text++;
            continue;
        }
        line = strsep(&text, "\n");
        lines[count++] = (PageLine){line, rows_of(page, line)};
        all += lines[count - 1].rows;
        if (result == 0 && begins_any(line, (const char *[]){"  expected ", "  it  ", NULL}))
            result = count - 1;
        if (tried == 0 && begins_any(line, (const char *[]){"  try  ", NULL}))
            tried = count;
    }
    snprintf(words, sizeof words, "  ...        %s shows all of it", command);
    int too_many = cut(lines, tried > 0 ? tried : 1, end, all - rows, words);
    if (result > 0)
        too_many = cut(lines, 2, result, too_many, words);
    all = 0;
    for (int i = 0; i < count; i++)
        if (lines[i].text != NULL) {
            fprintf(page->out, "%s\n", lines[i].text);
            all += lines[i].rows;
        }
    return all;
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
