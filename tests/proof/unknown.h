// unknown.h - wrong answers that are not known mistakes, and the verdict that each must get.
//
// They are two mistakes at once, or like a known one on some inputs only, or answers of another
// kind. It is better to name nobody than somebody else.
#ifndef TESTS_PROOF_UNKNOWN_H
#define TESTS_PROOF_UNKNOWN_H

#include "tests/judge/stem.h"
#include "tests/judge/switchboard.h"

#include <stddef.h>

typedef struct Unknown {
    const char *exercise; // the function that it answers
    AnyFunction *answer;
    const char *said; // ID, ID in part, ID and ID; or NOBODY and how the words begin
    const char *what; // how it is wrong, in a few words
} Unknown;

#define NOBODY "but"

#define UNKNOWN(exercise, answer, said, what)                                                      \
    {                                                                                              \
#exercise, (AnyFunction *)(answer), said, what                                             \
    }

// A stem has one table of them, OF_STEM(unknowns), which ends with one whose exercise is NULL.

#endif
