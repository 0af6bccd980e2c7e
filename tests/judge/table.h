// table.h - the table of a stem: the questions of its tests, the right results, and those of known
// mistakes.
//
// reference/record.c makes it from the tests, the reference and the mistakes, none of which it
// holds: only inputs, values, and the sentences that a student may read. The judge asks the
// questions of an answer (questions.c), in the toolkit and in the students' archive.
#ifndef TESTS_JUDGE_TABLE_H
#define TESTS_JUDGE_TABLE_H

#include "tests/judge/known.h"
#include "tests/judge/numbers.h"
#include "tests/judge/runner.h"

#include <stdio.h>

// One call of the function that a test is about.
typedef struct Question {
    const char *given; // lines: name, tab, value
    int hidden;        // it has random numbers of a SEED, which must not be shown
    Numbers arguments;
    Numbers *results; // the first is the right one; of the others question_result

    // What a test accepts.
    Numbers expected;       // the right result, with the numbers that the test says
    Numbers within;         // the tolerance of each: infinite if any is right; none if it does not
                            // look at the depth of a picture
    double tolerance;       // the least of them
    int reasons;            // the CameraFaults that are right, a bit each
    int length_is_free;     // whether the direction of a ray may have any length
    double least, most;     // the lengths of a step, or 0
    int is_seen_along_axes; // whether a vector is shown along forward, right and up of the camera

    // Of wrong answers: read by table_load_mistakes.
    int result_count, mistake_count;
    int *of_mistake; // which of the results each known mistake of the function gives
    const unsigned char **differences; // of each result from the right one
    Numbers corners; // of the image plane, from the eye, if a vector to it is asked for
    Numbers facts;   // what the law of the function needs to know (known.h)
} Question;

typedef struct {
    const char *function, *name; // the sentence
    int extra;                   // costs no marks
    int probe;                   // nothing is expected
    int question_count;
    Question *questions;
} TableTest;

typedef struct {
    int test_count, mistake_count;
    TableTest *tests;
    Mistake *mistakes; // their words; no formulas in an archive
    const char *stem;
    const unsigned char *bytes; // what is not read yet, in memory
    size_t size;
} Table;

// From the folder JUDGE_TABLES of the environment, or where make puts them. Exits with 2, and a
// message, if the stem has no table or it cannot be read.
void table_load(const char *stem, Table *table);

// The part that right answers do not need. Then the results of mistakes are there.
void table_load_mistakes(Table *table);
const Numbers *question_result(const Question *question, int i);

// False if the file cannot be written.
bool table_write(const char *path, Table *table);

// From malloc, one more of it; the new one is all zero.
void *table_grow(void *items, int *count, size_t size);

// ---- the tests of a table, as those of the stem that was chosen (questions.c) ------------------

// They ask the table's questions of whoever answers (message.h), and know the right results.

// The one that is being asked.
const Question *question_now(void);

// From now on answers are compared with mistakes and laws.
void questions_of_mistakes(void);

// The result of the nth mistake of the function for it; nth -1: the right one. A camera that is
// refused is so for all reasons that are right (numbers.h).
const Numbers *known_result(int exercise, int nth);

// Asks it once more.
const Numbers *ask_again(int exercise);

// ---- of a test that has failed -----------------------------------------------------------------

// The question at which it stopped; NULL if that is not known. All of it is read.
const Question *question_of(const Record *record);

// While it is on, the last answer in each test is kept; at first it is off.
void keep_answers(bool on);
// Of the test of this number; NULL if its last call had no answer.
const Numbers *answer_of(int test);

#endif
