// numbers.h - the numbers of the example, by the names that lessons and slides have for them:
// [[upper_left]] in chapters/lessons/lines.txt and in chapters/slides.txt.
#ifndef CHAPTERS_LESSONS_NUMBERS_H
#define CHAPTERS_LESSONS_NUMBERS_H

typedef struct {
    const char *name;
    char text[400];
} NamedNumber;

// All of them, for the example as it is now, until the next call. Numbers are as people write them
// (common/shown.h); in formulas fill.py makes them LaTeX.
const NamedNumber *named_numbers(int *count);

#endif
