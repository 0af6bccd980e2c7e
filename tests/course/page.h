// page.h - text for a reader: as wide as the terminal, and in color if the terminal has colors.
//
// The course in a browser (chapters/book/) has its own columns. For it, fields and words are
// written as parts, KIND \x1f LABEL \x1f WORDS \x1e, and what only a terminal's reader can use is
// left out: page_line and page_terminal.
#ifndef TESTS_COURSE_PAGE_H
#define TESTS_COURSE_PAGE_H

#include <stdbool.h>
#include <stdio.h>

typedef enum { PLAIN = 0, BOLD = 1, RED = 31, GREEN = 32, YELLOW = 33 } PageColor;

typedef struct {
    FILE *out;
    int columns; // that are written to: one less than there are
    bool colors;
    bool is_brief; // without what is the same each time
    bool is_web;   // for the course in a browser: parts
} Page;

// Columns: COLUMNS in the environment, the terminal's, or 80. Colors: on a terminal, unless
// NO_COLOR is set or TERM is dumb. Not brief. WEB in the environment: for a browser.
Page page_on(FILE *out);

// A line, and text, as printf writes it: for a terminal only.
void page_line(const Page *page, PageColor color, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void page_terminal(const Page *page, const char *format, ...) __attribute__((format(printf, 2, 3)));

// For a browser only: a part.
void page_part(const Page *page, const char *kind, const char *label, const char *words);

// A label in a column of its own, then words that wrap under each other. A vector in parentheses
// stays in one piece if it fits; a ~ is a blank that does not break.
enum { PAGE_LABEL = 13 };
void page_field(const Page *page, PageColor color, const char *label, const char *words);

// Words as printf writes them, which wrap: the first line begins in one column, the others in
// another.
void page_words(const Page *page, PageColor color, int first, int others, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

// A program's output: a limited number of lines under a label, without control characters.
void page_printed(const Page *page, const char *label, const char *text);

// One call of a test, as the records have it (tests/judge/runner.h); how: the way in which a test
// ended that expected nothing.
typedef struct {
    bool hidden;
    const char *given, *expected, *yours, *missing, *how, *printed;
} ShownCall;

// The arguments, the expected result, the student's or how it ended, and the first lines of the
// output. If the test is hidden, only how it ended.
void show_call(const Page *page, const ShownCall *call);

#endif
