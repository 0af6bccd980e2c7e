// page.h - text for a reader: as wide as the terminal, and in colour if the terminal has colours.
#ifndef TESTS_COURSE_PAGE_H
#define TESTS_COURSE_PAGE_H

#include <stdbool.h>
#include <stdio.h>

typedef enum { PLAIN = 0, BOLD = 1, RED = 31, GREEN = 32, YELLOW = 33 } PageColor;

typedef struct {
    FILE *out;
    int columns; // that are written to: one less than there are
    bool colors;
} Page;

// Columns: COLUMNS in the environment, the terminal's, or 80. Colours: on a terminal, unless
// NO_COLOR is set or TERM is dumb.
Page page_on(FILE *out);

// A line as it is.
void page_line(const Page *page, PageColor color, const char *line);

// A label in a column of its own, then words that wrap under each other. A vector in parentheses
// stays in one piece if it fits; a ~ is a blank that does not break.
enum { PAGE_LABEL = 13 };
void page_field(const Page *page, PageColor color, const char *label, const char *words);

// Words that wrap: the first line begins in one column, the others in another.
void page_words(const Page *page, PageColor color, int first, int others, const char *words);

// A program's output: a limited number of lines under a label, without control characters.
void page_printed(const Page *page, const char *label, const char *text);

#endif
