// mistakes.h - wrong answers that people really give, as code.
//
// Each stands in the file of its stem: what it computes, and the function it takes the place of.
// make check proves that each fails at least one test, and that each test is failed by one.
#ifndef TESTS_MISTAKES_H
#define TESTS_MISTAKES_H

#include "tests/judge/switchboard.h"

typedef struct {
    const char *id;       // C2, as the field's list of mistakes has it, or a name of our own
    const char *exercise; // the function that it answers wrongly
    AnyFunction *answer;
    const char *what; // what it does, in a few words
} Mistake;

#define MISTAKE(id, exercise, answer, what)                                                        \
    {                                                                                              \
        id, #exercise, (AnyFunction *)(answer), what                                               \
    }

// Of one stem; ends with a Mistake whose id is NULL.
extern const Mistake mistakes[];

#endif
