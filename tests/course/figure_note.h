// figure_note.h - the words below a figure that is drawn by wrong answers: which are wrong, and
// why.
#ifndef TESTS_COURSE_FIGURE_NOTE_H
#define TESTS_COURSE_FIGURE_NOTE_H

#include "tests/course/judging_plan.h"

#include <stdio.h>

// Writes a line about the answers that are wrong among those that the figure calls, and among those
// that these wait for. Nothing if none is.
void figure_note(FILE *out, const JudgingPlan *plan, int count, char *const *called);

#endif
