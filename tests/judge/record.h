// record.h - what is remembered of each test while it runs, in memory shared with its fork.
#ifndef TESTS_JUDGE_RECORD_H
#define TESTS_JUDGE_RECORD_H

#include <stdbool.h>

typedef struct {
    int cases;           // how many began
    bool closed;         // the current case has met its expectation
    bool finished;       // the test came to its end
    char given[2400];    // lines: name, tab, value
    char expected[1200]; // of the expectation that failed; empty where none did
    char yours[1200];
    char missing[64]; // the first blank that was called; empty where none was
} Record;

// Before all tests: memory for so many. Then one record a test, in the order in which they run.
void records_begin(int tests, const char *printed);
const Record *record_of(int test);

// The fixtures round each test: they choose the record, and catch what the student prints.
void record_setup(void);
void record_teardown(void);

#endif
