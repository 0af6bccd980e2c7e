// show.h - one test's outcome, for a reader at a terminal of 80 columns.
#ifndef TESTS_JUDGE_SHOW_H
#define TESTS_JUDGE_SHOW_H

#include "tests/judge/runner.h"

#include <stdio.h>

// What went in, what was expected, what came out or how it ended, and the first lines of what was
// printed (a file's path, or NULL).
void show_outcome(FILE *out, const Outcome *outcome, const char *printed);

#endif
