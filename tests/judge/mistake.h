// mistake.h - wrong answers that people really give, as code, and the sentences about each.
//
// They are in tests/NN-stem/mistakes*.c. make check proves that each fails a test of its function
// and is named from its values alone, and that each test is failed by one.
#ifndef TESTS_JUDGE_MISTAKE_H
#define TESTS_JUDGE_MISTAKE_H

#include "tests/judge/stem.h"
#include "tests/judge/switchboard.h"

#include <stddef.h>

typedef struct Mistake {
    const char *id;       // C2, as in the field's list of mistakes, or a name of our own
    const char *exercise; // the function that it answers wrongly
    AnyFunction *answer;
    const char *formula; // its formula, as the slide would write it
    const char *why;     // why it is wrong, in terms of the picture; whole sentences
    const char *picture; // what its author would see: 'everything at half its size'
} Mistake;

#define MISTAKE(id, exercise, answer, formula, why, picture)                                       \
    {                                                                                              \
        id, #exercise, (AnyFunction *)(answer), formula, why, picture                              \
    }

// A stem has one list of tables of them, OF_STEM(mistakes), which ends with NULL; each table ends
// with a Mistake whose id is NULL. chosen_mistakes() is the list of the stem that was chosen.

#endif
