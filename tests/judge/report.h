// report.h - what the judge found, as lines for a program (tests/grade/mark/marking.py).
//
// Lines of KEY tab VALUE. 'function' begins one: its name; 'state' is right, wrong, unanswered,
// waiting, timed out or crashed; the others are there where a test failed and there is something to
// say. In a value \n, \t and \\ stand for a line's end, a tab and a backslash, \xNN for what is not
// printable.
#ifndef TESTS_JUDGE_REPORT_H
#define TESTS_JUDGE_REPORT_H

#include "tests/judge/runner.h"
#include "tests/judge/suspects.h"

#include <stdio.h>

// Failed: the first test that did; NULL where all passed.
void report_function(FILE *out, const char *function, const Outcome *failed, Diagnosis diagnosis);

#endif
