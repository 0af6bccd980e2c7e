// runner.h - runs the listed tests, keeps a record of each while it runs, and how it ended.
#ifndef TESTS_JUDGE_RUNNER_H
#define TESTS_JUDGE_RUNNER_H

#include "common/camera.h"

#include <stdbool.h>
#include <stddef.h>

// ---- the record of each test while it runs, in memory shared with its fork ---------------------

// Why there was no answer, if there was none.
typedef enum { HOW_ANSWERED, HOW_CRASHED, HOW_TIMED_OUT } How;

typedef struct {
    int cases;            // how many began
    bool closed;          // the current case has met its expectation
    bool finished;        // the test came to its end
    bool extra;           // it costs no marks
    bool probe;           // nothing is expected: it only helps to distinguish mistakes
    bool hidden;          // it used random numbers of a SEED, which must not be shown
    const char *name;     // of the test
    const char *function; // the exercise that it tests
    char given[2400];     // lines: name, tab, value
    char expected[1200];  // of the expectation that failed; empty if none did
    char yours[1200];
    char missing[64]; // the first blank that was called; empty if none was
    How ended;
    char how[240];      // why there was no answer, in words; empty if there was one
    char printed[1500]; // what the answer printed in this test, to begin with
    int overran;        // the first case in which it wrote past the end of an array; 0: none
    char overran_given[2400];
} Record;

enum { CAMERA_WORDS = 1200 };

// After the last reading of them.
void records_end(void);

// Those of the last run are set aside while others run, and taken back.
typedef struct Records Records;
Records *records_aside(void);
void records_back(Records *records);
const Record *records_find(const Records *records, const char *name); // NULL if it is not there

// The output of the answer goes to this file (a descriptor); it is emptied before each test.
void records_catch_printed(int file);

const Record *record_of(int test);

// Of the test that is running, and its number.
Record *record_now(void);
int record_number(void);
void record_missing(const char *name); // this blank was called
bool record_is_missing(void);          // was any?
void record_keep_printed(void);
void record_how(How ended, const char *why); // there was no answer: ends the test
void record_overran(void);                   // this call wrote past the end of an array

// ---- running them ------------------------------------------------------------------------------

enum { MOST_TESTS = 200 };

typedef struct {
    const char *name;     // the sentence
    const char *function; // whose test it is
    bool extra;           // costs no marks
    bool passed;
    char how[240]; // how it ended, if it did not pass: in words
    const Record *record;
} Outcome;

typedef struct {
    int count;
    Outcome tests[MOST_TESTS];
} Outcomes;

// Tests of answers that are called directly may crash and hang, so each runs in a fork. Answers in
// another process cannot stop the judge, so their tests run in this process.
typedef enum { ANSWERS_HERE, ANSWERS_APART } WhereAnswersAre;

// Runs the tests of the stem that was chosen (known.h): those of one function, or those of one
// name, or (both NULL) all.
void run_tests(const char *function, const char *name, WhereAnswersAre where, Outcomes *outcomes);

// The probes of one function (suspects.h): all, or that of one name. No records if there are none.
void run_probes(const char *function, const char *name, Outcomes *outcomes);

// The last call of a test that has just ended, on stdout.
void show_outcome(const Outcome *outcome);

#endif
