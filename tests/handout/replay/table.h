// table.h - the table of a stem: the calls of its tests, the right results, and those of known
// mistakes.
//
// It is made by tests/handout/make_table.c from the tests, the reference and the mistakes, none of
// which it holds: only public inputs, values, and the sentences that a student may read.
#ifndef TESTS_HANDOUT_REPLAY_TABLE_H
#define TESTS_HANDOUT_REPLAY_TABLE_H

#include "tests/judge/known.h"
#include "tests/judge/numbers.h"

#include <stdio.h>

// One call of the function that a test is about.
typedef struct {
    char *given; // lines: name, tab, value
    Numbers arguments;
    int result_count; // results that differ; the first is the right one
    Numbers *results;
    int mistake_count;
    int *of_mistake; // which of them each known mistake of the function gives
    double
        tolerance; // of the test for numbers; absolute; infinite if it does not look at the depth
    int reasons;   // the CameraFaults that are right, a bit each; of a test, those that it accepts
    int length_is_free; // whether it accepts the direction of a ray in any length
    double least, most; // the accepted lengths of a step, relative to the right one; or 0
    Numbers corners;    // of the image plane, from the eye, if a vector to it is asked for
} ToldCall;

typedef struct {
    char *function, *name; // the sentence
    int extra;             // costs no marks
    int probe;             // nothing is expected
    int call_count;
    ToldCall *calls;
} ToldTest;

typedef struct {
    char *function, *why, *picture;
    int digits; // only extra tests can tell it from right
} ToldMistake;

typedef struct {
    int test_count, mistake_count;
    ToldTest *tests;
    ToldMistake *mistakes;
} Told;

// Exits with 2, and a message, if the stem has no table or it cannot be read.
void told_load(const char *stem, Told *told);

// False if the file cannot be written.
bool told_write(FILE *file, Told *told);

// Makes that of the stem that was chosen, where the tests are. False if it cannot be written.
bool table_make(const char *path);

// From malloc, one more of it; the new one is all zero.
void *told_grow(void *items, int *count, size_t size);

// ---- the tests of a table, run again with any answer -------------------------------------------

// Of the stem that was chosen.
const Told *told_table(void);

// The call that is being made.
const ToldCall *told_now(void);

#endif
