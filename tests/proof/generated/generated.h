// generated.h - wrong answers that nobody has thought of, as tests/proof/generated/mutate.c made
// them.
#ifndef TESTS_GENERATED_GENERATED_H
#define TESTS_GENERATED_GENERATED_H

#include "tests/judge/exercise.h"

typedef struct {
    const char *exercise;
    const char *from;   // the answer that was changed
    const char *change; // FUNCTION:LINE: the statement, [[what stood there => what stands there]]
    AnyFunction *answer;
} Generated;

// Of one stem; ends with one whose exercise is NULL.
extern const Generated generated[];

#endif
