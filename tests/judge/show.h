// show.h - one test's outcome, for a reader at a terminal of 80 columns.
#ifndef TESTS_JUDGE_SHOW_H
#define TESTS_JUDGE_SHOW_H

#include "tests/judge/runner.h"

#include <stdio.h>

enum { SHOW_COLUMNS = 79 };

// A label, then words that wrap under each other.
void show_field(FILE *out, const char *label, const char *words);

// What went in, what was expected, what came out or how it ended, and the first lines of what was
// printed. Where the test is hidden, only how it ended.
void show_outcome(FILE *out, const Outcome *outcome);

#endif
