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
    char how[160]; // how it ended, if it did not pass: in words
    const Record *record;
} Outcome;

typedef struct {
    int count;
    Outcome tests[MOST_TESTS];
} Outcomes;

// Tests of answers that are called directly may crash and hang, so each runs in a fork. Answers in
// another process cannot stop the judge, so their tests run in this process.
typedef enum { ANSWERS_HERE, ANSWERS_APART } WhereAnswersAre;

// Runs the tests of the stem that was chosen (stem.h): those of one function, or those of one name,
// or (both NULL) all.
void run_tests(const char *function, const char *name, WhereAnswersAre where, Outcomes *outcomes);

// The probes of one function (suspects.h). No records if there are none.
void run_listed_probes(const char *function, const char *name, Outcomes *outcomes);

#endif
