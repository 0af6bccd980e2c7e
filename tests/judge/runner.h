// runner.h - runs the listed tests in forks and keeps how each ended.
#ifndef TESTS_JUDGE_RUNNER_H
#define TESTS_JUDGE_RUNNER_H

#include "tests/judge/record.h"

#include <stdbool.h>

enum { MOST_TESTS = 200 };

typedef struct {
    const char *name;     // the sentence
    const char *function; // whose test it is
    bool extra;           // costs no marks
    bool passed;
    char how[100]; // how it ended, where it did not pass: in words
    const Record *record;
} Outcome;

typedef struct {
    int count;
    Outcome tests[MOST_TESTS];
} Outcomes;

// Runs those of one function, or those of one name, or (both NULL) all. What tests print goes to
// files in the folder printed, numbered in order from 0; where it is NULL it is not caught.
void run_tests(const char *function, const char *name, const char *printed, Outcomes *outcomes);

#endif
