// report.h - what the judge found, as lines for a program (tests/grade/mark/judge_report.py).
//
// Lines of KEY tab VALUE (tests/course/entries.h). 'function' begins one: its name; 'state' is
// right, wrong, unanswered, waiting, timed out or crashed; 'calls' names the exercises that it
// entered when it was called, with a blank between them; 'extra' is right or wrong: its tests that
// cost no marks. The others are there where a test failed and there is something to say: 'test' its
// name, 'case' the number of the call that failed, 'given' lines of a name, a tab and a value, ...
#ifndef TESTS_JUDGE_REPORT_H
#define TESTS_JUDGE_REPORT_H

#include "tests/judge/runner.h"
#include "tests/judge/suspects.h"

#include <stdio.h>

// Failed: the first test that did; NULL if all passed.
void report_function(FILE *out, const char *function, const Outcome *failed, Diagnosis diagnosis);
// After it, if it has extra tests: of those.
void report_extra(FILE *out, const Outcome *failed);

#endif
