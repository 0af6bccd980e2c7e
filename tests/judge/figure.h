// figure.h - a wrong answer beside the right one, as numbers for a layout.
//
// For a function whose test failed, FOLDER/FUNCTION.gp is a script for gnuplot
// (common/figure/plot.h), or FOLDER/FUNCTION.png a picture; neither if there is nothing to draw: no
// answer, one that is not finite or far beyond what can be shown beside the right one, or hidden
// inputs.
#ifndef TESTS_JUDGE_FIGURE_H
#define TESTS_JUDGE_FIGURE_H

#include "common/figure/plot.h"
#include "tests/judge/process_transport.h"
#include "tests/judge/runner.h"
#include "tests/judge/suspects.h"

// Removes the figure of an older answer.
void figure_forget(const char *folder, const char *function);

void figure_write(const char *folder, const Record *record, Kept *kept, Diagnosis diagnosis);

#endif
