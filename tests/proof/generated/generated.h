// generated.h - wrong answers, as tests/proof/generated/mutate.c makes them.
#ifndef TESTS_GENERATED_GENERATED_H
#define TESTS_GENERATED_GENERATED_H

#include "tests/judge/exercise.h"
#include "tests/judge/stem.h"

typedef struct Generated {
    const char *exercise;
    const char *from;   // the answer that was changed
    const char *change; // FUNCTION:LINE: the statement, [[old text => new text]]
    AnyFunction *answer;
} Generated;

// A stem has one table of them, OF_STEM(generated), which ends with one whose exercise is NULL.

#endif
