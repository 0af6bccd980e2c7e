// slips.h - every possible slip in a function: tokens from..to become another text.
#ifndef TESTS_GENERATED_SLIPS_H
#define TESTS_GENERATED_SLIPS_H

#include "tests/proof/generated/source.h"

enum { MOST_SLIPS = 4000, SLIP_TEXT = 400 };

typedef struct {
    int item, from, to; // the function, and its tokens that go
    char text[SLIP_TEXT];
} Slip;

typedef struct {
    int count;
    Slip slips[MOST_SLIPS];
} Slips;

// Adds those of one function. Not all of them are C: the compiler is asked.
void slips_of(const Source *source, int item, Slips *slips);

#endif
