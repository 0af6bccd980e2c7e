// show_verdicts.h - the records of the chapters, as a student reads them.
#ifndef TESTS_COURSE_SHOW_VERDICTS_H
#define TESTS_COURSE_SHOW_VERDICTS_H

#include "tests/course/judging.h"
#include "tests/course/page.h"

// The names of the figures that were shown and are still to be drawn.
enum { MOST_SHOWN = 200 };
typedef struct {
    int count;
    char names[MOST_SHOWN][64];
} ShownFigures;

typedef enum { ALL_RIGHT, SOMETHING_WRONG, BLANKS_LEFT } Standing;

// The first thing that needs work (all: everything), how far the chapters are, and what is next.
Standing show_verdicts(const Page *page, const Judging *judging, const bool chosen[MOST_CHAPTERS],
                       bool all, ShownFigures *shown);

// How many functions are right, of all chapters, when each was judged last; and how many there are.
typedef struct {
    int right, of;
} Progress;
Progress progress_so_far(const JudgingPlan *plan);

// Which function a hint is for: the first wrong one, the first blank, or the last that waits; NULL
// if all are right. Which one gdb stops at: the first wrong one, or NULL.
const FunctionRecord *function_for_hint(const ChapterRecord *record);
const FunctionRecord *function_for_debug(const ChapterRecord *record);

#endif
