// generated.h - wrong answers that nobody has thought of, as tests/proof/generated/mutate.c made
// them.
#ifndef TESTS_GENERATED_GENERATED_H
#define TESTS_GENERATED_GENERATED_H

#include "tests/judge/exercise.h"
#include "tests/judge/stem.h"

typedef struct Generated {
    const char *exercise;
    const char *from;   // the answer that was changed
    const char *change; // FUNCTION:LINE: the statement, [[what stood there => what stands there]]
    AnyFunction *answer;
} Generated;

// A stem has one table of them, OF_STEM(generated), which ends with one whose exercise is NULL.

#endif
