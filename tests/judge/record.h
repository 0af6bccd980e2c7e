// record.h - the record of each test while it runs, in memory shared with its fork.
#ifndef TESTS_JUDGE_RECORD_H
#define TESTS_JUDGE_RECORD_H

#include "common/camera.h"

#include <stdbool.h>
#include <stddef.h>

// Why there was no answer, if there was none.
typedef enum { HOW_ANSWERED, HOW_CRASHED, HOW_TIMED_OUT } How;

typedef struct {
    int cases;           // how many began
    bool closed;         // the current case has met its expectation
    bool finished;       // the test came to its end
    bool extra;          // it costs no marks
    bool probe;          // nothing is expected: it only helps to distinguish mistakes
    bool hidden;         // it used random numbers of a SEED, which must not be shown
    const char *name;    // of the test
    char function[64];   // the exercise that it tests
    char given[2400];    // lines: name, tab, value
    char expected[1200]; // of the expectation that failed; empty if none did
    char yours[1200];
    char missing[64]; // the first blank that was called; empty if none was
    How ended;
    char how[160];      // why there was no answer, in words; empty if there was one
    char printed[1500]; // what the answer printed in this test, to begin with
    int overran;        // the first case in which it wrote past the end of an array; 0: none
    char overran_given[2400];
} Record;

enum { CAMERA_WORDS = 1200 };

// Before all tests: memory for this many. Then one record a test, in the order in which they run.
void records_begin(int tests);
// After the last reading of them.
void records_end(void);
void record_is_of(int test, const char *name, const char *function, bool extra, bool probe);

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
void record_fails_by_overrun(int test);      // and nothing else is wrong: the test is about it

// The fixtures around each test.
void record_setup(void);
void record_teardown(void);

#endif
