// composed.h - right answers that ask other exercises of their chapter, whoever answers those.
//
// A student may make the mistake of one function inside another that does the same by itself.
#ifndef TESTS_PROOF_COMPOSED_H
#define TESTS_PROOF_COMPOSED_H

#include "tests/judge/stem.h"
#include "tests/judge/switchboard.h"

#include <stddef.h>

typedef struct Composed {
    const char *exercise;
    AnyFunction *answer;
} Composed;

// A mistake of one exercise that gives the same in another as one of its own, on whatever input: it
// is named as that. Of any other nobody must be named.
typedef struct SameMistake {
    const char *exercise;
    const char *part; // the id of the mistake in what it asks
    const char *said; // ID, ID in part, ID and ID, as in tests/proof/unknown.h
} SameMistake;

// In a file that includes the solution, whose functions are weak there (build/weak.h): its calls
// go to the judge's proxies, and this is the solution's own function.
#define SOLUTION(exercise)                                                                         \
    extern __typeof__(exercise) own_##exercise __attribute__((alias(#exercise)))

#define COMPOSED(exercise, answer)                                                                 \
    {                                                                                              \
#exercise, (AnyFunction *)(answer)                                                         \
    }

// A stem has one table of each, OF_STEM(composed) and OF_STEM(same_mistakes), which end with one
// whose exercise is NULL; none if no function of it asks another.

#endif
