// variants.h - right answers, written in other ways than the reference.
//
// None may fail or be accused of a mistake: make check proves it.
#ifndef TESTS_PROOF_VARIANTS_H
#define TESTS_PROOF_VARIANTS_H

#include "tests/judge/stem.h"
#include "tests/judge/switchboard.h"

#include <stddef.h>

typedef struct Variant {
    const char *exercise; // the function that it answers
    AnyFunction *answer;
    const char *what; // how it differs, in a few words
} Variant;

#define VARIANT(exercise, answer, what)                                                            \
    {                                                                                              \
#exercise, (AnyFunction *)(answer), what                                                   \
    }

// A stem has one table of them, OF_STEM(variants), which ends with one whose exercise is NULL.

#endif
