// judging.h - judges the chapters whose record is about another answer than the one that is there.
#ifndef TESTS_COURSE_JUDGING_H
#define TESTS_COURSE_JUDGING_H

#include "tests/course/chapter_record.h"
#include "tests/course/judging_plan.h"

#include <stdint.h>

// A hash of everything that judges each chapter; files that do not change while a program runs are
// read once.
typedef struct {
    const JudgingPlan *plan;
    uint64_t tools[MOST_CHAPTERS];
} Judging;
Judging judging_begin(const JudgingPlan *plan);

// The record of a chapter. False if there is none, or it is about another text.
bool judging_record(const Judging *judging, int chapter, ChapterRecord *record);

// Judges those of the wanted chapters, and of those that they call, whose record is out of date; in
// parallel, if there are processors. Waits for another run in the same folder. False, and a message
// on stderr, if a record cannot be written.
bool judging_judge(const Judging *judging, const bool wanted[MOST_CHAPTERS]);

#endif
