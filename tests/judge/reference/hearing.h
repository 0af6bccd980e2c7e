// hearing.h - what the answer made of a call, told to the suspects (suspects.h) by the proxies.
#ifndef TESTS_JUDGE_REFERENCE_HEARING_H
#define TESTS_JUDGE_REFERENCE_HEARING_H

#include "tests/judge/wire.h"

// Where the call is of interest: to put what went in, and then what came out. Else NULL.
Wire *hear_question(int exercise);
Wire *hear_answer(int exercise);

// Both are there.
void hear(int exercise);

#endif
