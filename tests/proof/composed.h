// composed.h - right answers that ask other exercises of their chapter, whoever answers those.
//
// A student may make the mistake of one function inside another that does the same by itself.
#ifndef TESTS_PROOF_COMPOSED_H
#define TESTS_PROOF_COMPOSED_H

#include "tests/judge/switchboard.h"

#include <stddef.h>

typedef struct {
    const char *exercise;
    AnyFunction *answer;
} Composed;

// A mistake of one exercise that gives the same in another as one of its own, on whatever input: it
// is named as that. Of any other nobody must be named.
typedef struct {
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

// Of one stem; ends with one whose exercise is NULL. Not defined where no function asks another.
extern const Composed composed[];
extern const SameMistake same_mistakes[];

#endif
