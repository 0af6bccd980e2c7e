// show.h - one call of a test, for a reader at a terminal.
#ifndef TESTS_JUDGE_SHOW_H
#define TESTS_JUDGE_SHOW_H

#include "tests/course/page.h"
#include "tests/judge/runner.h"

#include <stdio.h>

// As the records have it (record.h); how: the way in which a test ended that expected nothing.
typedef struct {
    bool hidden;
    const char *given, *expected, *yours, *missing, *how, *printed;
} ShownCall;

// The arguments, the expected result, the student's or how it ended, and the first lines of the
// output. If the test is hidden, only how it ended.
void show_call(const Page *page, const ShownCall *call);

// The same for a test that has just ended.
void show_outcome(FILE *out, const Outcome *outcome);

#endif
