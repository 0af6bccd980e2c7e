// mistake.h - a known wrong answer, and what to say of it.
#ifndef TESTS_JUDGE_MISTAKE_H
#define TESTS_JUDGE_MISTAKE_H

#include "tests/judge/switchboard.h"

typedef struct {
    const char *id;       // C2, as the field's list of mistakes has it, or a name of our own
    const char *exercise; // the function that it answers wrongly
    AnyFunction *answer;
    const char *formula; // what it computes, as the slide would write it
    const char *why;     // why that is wrong, in terms of the picture; whole sentences
    const char *picture; // what its author would see: 'everything at half its size'
} Mistake;

// The tables of one stem, and NULL; each table ends with a Mistake whose id is NULL.
extern const Mistake *const mistakes[];

#endif
